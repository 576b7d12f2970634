# Trials that stand out of an additive model, and what R's lm says of them. See README.md.
options(digits = 17)

samples <- data.frame()
values <- data.frame()
note <- function(sample, quantity, value) {
  values <<- rbind(values, data.frame(sample = sample, quantity = quantity, value = unname(value)))
}

# The generalized extreme studentized residual (Paul and Fung 1991), with exact leverages.
outliers <- function(x, alpha = 0.05, most = 20) {
  fit_without <- function(out) lm(value ~ participant + condition, x,
                                  subset = !(seq_len(nrow(x)) %in% out))
  out <- studentized <- exceeds <- c()
  for (i in seq_len(min(most, fit_without(c())$df.residual / 5))) {
    fit <- fit_without(out)
    r <- rstandard(fit)
    n <- length(r)
    df <- fit$df.residual
    t <- qt(1 - alpha / (2 * n), df - 1)
    worst <- which.max(abs(r))
    out <- c(out, as.integer(names(r)[worst]))
    studentized <- c(studentized, r[worst])
    exceeds <- c(exceeds, abs(r[worst]) > t * sqrt(df / (df - 1 + t^2)))
  }
  count <- max(0, which(exceeds))
  out <- head(out, count)
  fit <- fit_without(out)
  list(index = out, studentized = head(studentized, count),
       deviation = x$value[out] - predict(fit, x[out, ]))
}

set.seed(20180420)
study <- function(participants, conditions) {
  x <- expand.grid(condition = seq_len(conditions), participant = seq_len(participants))
  x$value <- rnorm(participants, 2, 0.4)[x$participant] + rnorm(conditions, 0, 0.5)[x$condition] +
    rnorm(nrow(x), 0, 0.3)
  x$value <- signif(x$value, 6)
  x[c("participant", "condition", "value")]
}
slower <- function(x, trials) {
  x$value[trials] <- signif(x$value[trials] + log(5), 6)
  x
}
designs <- list(clean = study(16, 15), one = slower(study(16, 15), 100),
  three_of_one_participant = slower(study(16, 15), c(31, 35, 38)),
  scattered = slower(study(24, 15), c(5, 77, 200, 301)),
  missing_cells = slower(study(16, 15)[-c(3, 40, 41, 150), ], c(20, 111)))
designs$fast <- designs$one
designs$fast$value[100] <- designs$fast$value[100] - 2 * log(5)
for (name in names(designs)) {
  x <- designs[[name]]
  rownames(x) <- NULL
  samples <- rbind(samples, data.frame(sample = name, row = x$participant, column = x$condition,
                                       value = x$value))
  x$participant <- factor(x$participant)
  x$condition <- factor(x$condition)
  found <- outliers(x)
  note(name, "count", length(found$index))
  for (i in seq_along(found$index)) {
    note(name, paste0("trial_", i), found$index[i])
    note(name, paste0("studentized_", i), found$studentized[i])
    note(name, paste0("deviation_", i), found$deviation[i])
  }
}

exact <- function(x) sprintf("%.17g", x)
samples$value <- exact(samples$value)
values$value <- exact(values$value)
write.csv(samples, "outliers_samples.csv", row.names = FALSE, quote = FALSE)
write.csv(values, "outliers_values.csv", row.names = FALSE, quote = FALSE)
