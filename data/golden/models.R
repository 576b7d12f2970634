# Crossed mixed models of paired log times, and what lme4 and lmerTest say of them. See README.md.
options(digits = 17)
suppressMessages({
  library(lme4)
  library(lmerTest)
  library(numDeriv)
})

samples <- data.frame()
values <- data.frame()
# A sample is a matrix: a row for each participant, a column for each scene.
keep <- function(name, x) {
  samples <<- rbind(samples, data.frame(sample = name, row = rep(seq_len(nrow(x)), ncol(x)),
                                        column = rep(seq_len(ncol(x)), each = nrow(x)),
                                        value = as.vector(x)))
}
note <- function(sample, quantity, value) {
  values <<- rbind(values, data.frame(sample = sample, quantity = quantity, value = unname(value)))
}

# lme4's optimum is only as exact as its optimizer. Its own deviance is minimized again within every
# face of the boundary (each variance at 0 or free), as a function of the variances relative to the
# residual's, of which 0 is no stationary point, with Newton's steps at the end; and the least of all
# faces' minima is taken.
polished <- function(formula, data) {
  parts <- lFormula(formula, data, REML = TRUE)
  deviance_of <- do.call(mkLmerDevfun, parts)
  rough <- optimizeLmer(deviance_of, optimizer = "bobyqa", control = list(rhoend = 1e-9))$par
  k <- length(rough)
  best <- NULL
  for (face in 0:(2^k - 1)) {
    free <- bitwAnd(face, 2^(seq_len(k) - 1)) > 0
    theta_of <- function(part) replace(numeric(k), free, sqrt(part))
    inner <- function(part) deviance_of(theta_of(part))
    variances <- pmax(rough, 0.1)[free]^2
    if (any(free)) {
      variances <- nlminb(variances, inner, lower = 0, control = list(rel.tol = 1e-15))$par
      if (any(variances < 1e-6)) next # this face's minimum lies in a smaller face
      for (step in 1:6) {
        slope <- grad(inner, variances, method.args = list(d = 0.05, r = 6))
        variances <- variances - solve(hessian(inner, variances), slope)
      }
    }
    found <- list(par = theta_of(variances), fval = inner(variances), conv = 0)
    if (is.null(best) || found$fval < best$fval - 1e-9) best <- found
  }
  deviance_of(best$par)
  mkMerMod(environment(deviance_of), best, parts$reTrms, fr = parts$fr)
}

# Draws that have the wanted mean squares: `holds` of those of participants, scenes and residual.
draw <- function(a, b, participant, scene, holds) {
  repeat {
    d <- outer(rnorm(a, 0, participant), rnorm(b, 0, scene), "+") + rnorm(a * b, log(0.5), 0.42)
    d <- signif(d, 6)
    rest <- d - outer(rowMeans(d), colMeans(d), "+") + mean(d)
    if (holds(b * var(rowMeans(d)), a * var(colMeans(d)), sum(rest^2) / ((a - 1) * (b - 1)))) return(d)
  }
}
interior <- function(p, s, e) p > e && s > e

set.seed(20180417)
designs <- list(
  interior_12x5 = draw(12, 5, 0.2, 0.2, interior), interior_16x5 = draw(16, 5, 0.2, 0.1, interior),
  interior_40x5 = draw(40, 5, 0.1, 0.2, interior), interior_3x2 = draw(3, 2, 0.5, 0.5, interior),
  interior_24x3 = draw(24, 3, 0.4, 0.05, function(p, s, e) interior(p, s, e) && s > 1.2 * e && s < 1.5 * e),
  no_participants_12x5 = draw(12, 5, 0, 0.2, function(p, s, e) p < e && s > e),
  no_participants_16x5 = draw(16, 5, 0, 0.1, function(p, s, e) p < e && s > e),
  no_participants_3x2 = draw(3, 2, 0, 0.5, function(p, s, e) p < e && s > e),
  no_scenes_12x5 = draw(12, 5, 0.2, 0, function(p, s, e) p > e && s < e),
  no_scenes_40x5 = draw(40, 5, 0.2, 0, function(p, s, e) p > e && s < e),
  no_scenes_3x2 = draw(3, 2, 0.5, 0, function(p, s, e) p > e && s < e),
  neither_16x5 = draw(16, 5, 0, 0, function(p, s, e) p < 0.9 * e && s < 0.7 * e),
  neither_40x5 = draw(40, 5, 0, 0, function(p, s, e) p < 0.9 * e && s < 0.7 * e),
  neither_3x2 = draw(3, 2, 0, 0, function(p, s, e) p < 0.7 * e && s < 0.5 * e),
  # Below the residual, and above it once the other is pooled with it: either way round.
  scenes_after_pooling_12x5 = draw(12, 5, 0, 0.05, function(p, s, e)
    p < 0.6 * e && s < e && s > 1.02 * (11 * p + 44 * e) / 55),
  participants_after_pooling_12x5 = draw(12, 5, 0.05, 0, function(p, s, e)
    s < 0.3 * e && p < e && p > 1.02 * (4 * s + 44 * e) / 48),
  # Nearly as large as the residual, and pooled with it after the other.
  neither_in_turn_12x5 = draw(12, 5, 0, 0, function(p, s, e)
    s < 0.5 * e && p < (4 * s + 44 * e) / 48 && p > 0.8 * e))

for (name in names(designs)) {
  d <- designs[[name]]
  keep(name, d)
  long <- data.frame(d = as.vector(d), participant = factor(row(d)), scene = factor(col(d)))
  fit <- polished(d ~ 1 + (1 | participant) + (1 | scene), long)
  variances <- as.data.frame(VarCorr(fit))
  variance <- function(group) variances$vcov[variances$grp == group]
  found <- coef(summary(lmerTest::lmer(d ~ 1 + (1 | participant) + (1 | scene), long,
    control = lmerControl(optimizer = "bobyqa", optCtrl = list(rhoend = 1e-10)))))
  note(name, "mean", fixef(fit))
  note(name, "standard_error", sqrt(vcov(fit)[1, 1]))
  note(name, "participant_variance", variance("participant"))
  note(name, "scene_variance", variance("scene"))
  note(name, "residual_variance", variance("Residual"))
  note(name, "lmertest_df", found[1, "df"]) # by numerical derivatives: to some six digits
  note(name, "t", fixef(fit) / sqrt(vcov(fit)[1, 1]))
  note(name, "lmertest_p", found[1, "Pr(>|t|)"])
}

# The same comparison from the times themselves -------------------------------------------------------
set.seed(20180418)
a <- 12
b <- 5
each <- function(n, sd) matrix(rnorm(2 * n, 0, sd), n)
of_person <- each(a, 0.2)
of_scene <- each(b, 0.2)
shared <- outer(rnorm(a, 0, 0.4), rnorm(b, 0, 0.3), "+") + rnorm(a * b, 0, 0.2)
times <- lapply(1:2, function(m) signif(exp(shared + outer(of_person[, m], of_scene[, m], "+") +
                                            c(2, 1.2)[m] + rnorm(a * b, 0, 0.3)), 6))
keep("times_12x5", do.call(cbind, times)) # the baseline's five scenes, then the method's
long <- data.frame(t = log(unlist(times)), participant = factor(rep(row(shared), 2)),
                   scene = factor(rep(col(shared), 2)),
                   method = factor(rep(1:2, each = a * b)))
fit <- polished(t ~ method + (1 | participant) + (1 | participant:method) + (1 | scene) +
                (1 | scene:method) + (1 | participant:scene), long)
stopifnot(getME(fit, "theta") > 0.01) # interior, where the strata are those of the differences
variances <- as.data.frame(VarCorr(fit))
note("times_12x5", "mean", fixef(fit)[2])
note("times_12x5", "standard_error", sqrt(vcov(fit)[2, 2]))
for (group in c("participant:method", "scene:method", "Residual")) {
  note("times_12x5", sub(":method", "_variance", sub("Residual", "residual:method", group)),
       2 * variances$vcov[variances$grp == group])
}

exact <- function(x) sprintf("%.17g", x)
samples$value <- exact(samples$value)
values$value <- exact(values$value)
write.csv(samples, "models_samples.csv", row.names = FALSE, quote = FALSE)
write.csv(values, "models_values.csv", row.names = FALSE, quote = FALSE)
for (package in c("lme4", "lmerTest", "numDeriv")) {
  cat(package, as.character(packageVersion(package)), "\n")
}
