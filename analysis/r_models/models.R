# Fits the models of studies' planned and other comparisons of two methods.
#
#   Rscript models.R [FOLDER...]   (the working folder by default)
#
# in each folder, which is of one study,
# reads   trials_long.csv        a row for each trial
#         models_plan.csv        a row for each comparison: measure, method, reference, whether
#                                scenes are random or fixed, the measure's kind: time, points
#                                (a rating with few) or scale (a rating with many), and whether
#                                profile intervals and leave-one-out estimates are wanted: full or
#                                not: p_only
# writes  r_models.csv           a row for each model of each comparison
#         r_versions.csv         the versions of R and of the packages that were used
#
# What cannot be fitted has a row without P, whose columns say so: `status` failed or singular, and
# `note` why. Nothing ends in an error but files that are not there. Needs lme4 and lmerTest for
# times and scales, survival for right-censored times, ordinal for points; without a package its rows
# say so.

confidence <- 0.95

# Scale of an estimate: natural logarithms of ratios of times, method over reference, and of odds
# ratios of a higher rating; points of a scale with many.
scale_of <- function(comparison) {
  c(time = "ratio", points = "odds ratio", scale = "points")[[comparison$kind]]
}

# One row of r_models.csv.
result <- function(comparison, model, estimate = NA, standard_error = NA, degrees_of_freedom = NA,
                   trials = 0, participants = 0, scenes = 0, censored = 0,
                   participant_sd = NA, scene_sd = NA, residual_sd = NA, note = "",
                   half = qt((1 + confidence) / 2, degrees_of_freedom) * standard_error,
                   low = estimate - half, high = estimate + half,
                   p = 2 * pt(-abs(estimate / standard_error), degrees_of_freedom),
                   status = if (is.na(p)) "failed" else "fitted", leave_one_out = NULL) {
  if (is.null(leave_one_out)) leave_one_out <- no_leave_one_out
  data.frame(measure = comparison$measure, method = comparison$method,
             reference = comparison$reference, model = model, scale = scale_of(comparison),
             status = status, note = note, estimate = estimate, standard_error = standard_error,
             degrees_of_freedom = degrees_of_freedom, low = low, high = high, p = p,
             trials = trials, participants = participants, scenes = scenes, censored = censored,
             participant_sd = participant_sd, scene_sd = scene_sd, residual_sd = residual_sd,
             leave_one_out, stringsAsFactors = FALSE)
}

no_leave_one_out <- list(without_one_low = NA_real_, low_without = "", without_one_high = NA_real_,
                         high_without = "")

# Returns the minimum and maximum of estimate(rows) without one participant, with that participant;
# NULL if they are not wanted, or if one has no value.
leave_one_out <- function(rows, comparison, estimate) {
  people <- levels(rows$participant)
  if (comparison$detail != "full" || length(people) < 3) return(NULL)
  found <- vapply(people, function(code) {
    tryCatch(suppressWarnings(estimate(droplevels(rows[rows$participant != code, ]))),
             error = function(e) NA_real_)
  }, 0)
  if (!all(is.finite(found))) return(NULL)
  list(without_one_low = min(found), low_without = people[which.min(found)],
       without_one_high = max(found), high_without = people[which.max(found)])
}

# Calls fit(), and turns an error into a row; warnings go into the row's note.
guarded <- function(comparison, model, packages, fit) {
  missing <- packages[!vapply(packages, requireNamespace, TRUE, quietly = TRUE)]
  if (length(missing) > 0) {
    return(result(comparison, model,
                  note = paste("R has no package", paste(missing, collapse = " and "))))
  }
  warned <- character()
  row <- tryCatch(
    withCallingHandlers(fit(), warning = function(w) {
      warned <<- c(warned, conditionMessage(w))
      invokeRestart("muffleWarning")
    }),
    error = function(e) result(comparison, model, note = conditionMessage(e)))
  # A mean difference has at least one degree of freedom. Satterthwaite's approximation gives less
  # if the optimizer stopped near a zero variance, where t has P = 1.
  freedom <- row$degrees_of_freedom
  failed <- isTRUE(freedom < 0.9)
  if (failed) {
    row[c("standard_error", "degrees_of_freedom", "low", "high", "p")] <- NA
    row$status <- "failed"
  }
  notes <- unique(c(row$note, if (failed) sprintf("the fit failed (%.1g degrees of freedom)", freedom),
                    warned))
  row$note <- gsub("[[:space:]]+", " ", paste(notes[nzchar(notes)], collapse = "; "))
  if (is.na(row$p) && grepl("Hessian.*singular", row$note)) row$status <- "singular"
  row
}

# Returns the trials of a comparison's two methods with a value, with `value` and `censored`.
trials_of <- function(trials, comparison) {
  is_time <- comparison$kind == "time"
  rows <- trials[trials$method %in% c(comparison$method, comparison$reference), ]
  rows$value <- as.numeric(rows[[paste0(comparison$measure, if (is_time) "_s" else "_rating")]])
  rows$censored <- if (is_time) {
    rows[[paste0(comparison$measure, "_censored")]] %in% "TRUE"
  } else {
    rep(FALSE, nrow(rows))
  }
  rows <- rows[!is.na(rows$value) & (!is_time | rows$value > 0), ]
  rows$method <- factor(rows$method, levels = c(comparison$reference, comparison$method))
  rows$participant <- factor(rows$participant)
  rows$scene <- factor(rows$scene)
  rows
}

# Returns an empty text if the data suffice to fit a model.
why_not <- function(rows) {
  if (nlevels(rows$participant) < 2) return("fewer than two participants")
  if (nlevels(droplevels(rows$method)) < 2) return("one of the methods has no values")
  ""
}

counts <- function(rows) {
  list(trials = nrow(rows), participants = nlevels(rows$participant),
       scenes = nlevels(rows$scene), censored = sum(rows$censored))
}

# Returns the differences of the pairs: method less reference by one participant in one scene, of
# times their logarithms.
pairs_of <- function(rows, is_time) {
  rows$compared <- if (is_time) log(rows$value) else rows$value
  rows <- rows[!rows$censored, c("participant", "scene", "method", "compared")]
  of <- function(method) rows[rows$method == method, c("participant", "scene", "compared")]
  pairs <- merge(of(levels(rows$method)[2]), of(levels(rows$method)[1]),
                 by = c("participant", "scene"))
  pairs$difference <- pairs$compared.x - pairs$compared.y
  droplevels(pairs)
}

# The mixed model of pairs' differences in which people differ, and so do scenes: that of log times
# or points ~ method with participants, scenes, both of their interactions with the method, and
# participant:scene. Without these, every trial would count as one more participant.
mixed_model <- function(pairs, scenes) {
  fit <- fit_mixed(pairs, scenes)
  row <- coef(summary(fit))[1, ]
  deviations <- as.data.frame(lme4::VarCorr(fit))
  deviation <- function(group) {
    found <- deviations$sdcor[deviations$grp == group]
    if (length(found) == 1) found else NA
  }
  list(estimate = row[["Estimate"]], standard_error = row[["Std. Error"]],
       degrees_of_freedom = row[["df"]], participant_sd = deviation("participant"),
       scene_sd = deviation("scene"), residual_sd = deviation("Residual"))
}

fit_mixed <- function(pairs, scenes) {
  if (nlevels(pairs$participant) < 2) stop("fewer than two participants")
  if (nlevels(pairs$scene) < 2) stop("one scene: the paired t test is this model")
  model <- if (scenes == "random") {
    difference ~ 1 + (1 | participant) + (1 | scene)
  } else {
    # The intercept is the mean over the scenes.
    contrasts(pairs$scene) <- contr.sum(nlevels(pairs$scene))
    difference ~ 1 + scene + (1 | participant)
  }
  lmerTest::lmer(model, data = pairs, control = lme4::lmerControl(
    check.conv.singular = "ignore", optimizer = "nloptwrap",
    optCtrl = list(xtol_abs = 1e-12, ftol_abs = 1e-14, maxeval = 10000)))
}

crossed_model <- function(rows, comparison) {
  pairs <- pairs_of(rows, comparison$kind == "time")
  of_pairs <- list(trials = 2 * nrow(pairs), participants = nlevels(pairs$participant),
                   scenes = nlevels(pairs$scene), censored = sum(rows$censored))
  has_gaps <- nrow(pairs) < nlevels(pairs$participant) * nlevels(pairs$scene)
  others <- if (has_gaps) {
    leave_one_out(pairs, comparison, function(rest) {
      lme4::fixef(fit_mixed(rest, comparison$scenes))[[1]]
    })
  }
  do.call(result, c(list(comparison, "crossed", leave_one_out = others),
                    mixed_model(pairs, comparison$scenes), of_pairs))
}

# A Tobit model of single trials, with terms for participants and scenes: a right-censored time says
# that the log time is longer. With fixed scenes each has its own ratio, of which the mean is
# estimated; where one cannot have, and with random scenes, they have one ratio in common.
tobit_model <- function(rows, comparison) {
  rows <- with_a_measured_time(rows)
  if (nzchar(why_not(rows))) stop(why_not(rows))
  for (method in levels(rows$method)) {
    if (all(rows$censored[rows$method == method])) {
      stop("every time of ", method, " is right-censored")
    }
  }
  is_random <- nlevels(rows$scene) > 1 && comparison$scenes == "random"
  terms <- scene_terms(rows, is_random)
  fit <- fit_tobit(rows, terms)
  rows$influence <- residuals(fit, type = "dfbeta")[, 2]
  error <- if (is_random) crossed_error(rows) else clustered_error(rows, length(coef(fit)))
  note <- if (is_random || nlevels(rows$scene) == 1 || grepl("method:", terms)) "" else
    "in a scene every time of a method is right-censored: all scenes have one ratio"
  others <- leave_one_out(rows, comparison, function(rest) {
    rest <- with_a_measured_time(rest)
    coef(fit_tobit(rest, scene_terms(rest, is_random)))[[2]]
  })
  do.call(result, c(list(comparison, "tobit", coef(fit)[[2]], residual_sd = sqrt(2) * fit$scale,
                         note = note, leave_one_out = others), error, counts(rows)))
}

fit_tobit <- function(rows, terms) {
  survival::survreg(
    as.formula(paste("survival::Surv(log(value), !censored) ~ method + participant", terms)),
    data = rows, dist = "gaussian", model = TRUE, x = TRUE, y = TRUE,
    control = survival::survreg.control(maxiter = 100))
}

# Sum contrasts: the method's own term is the mean over the scenes.
scene_terms <- function(rows, is_random) {
  if (nlevels(rows$scene) == 1) return("")
  measured <- with(rows[!rows$censored, ], table(scene, method))
  paste("+ C(scene, contr.sum)",
        if (!is_random && all(measured > 0)) "+ method:C(scene, contr.sum)")
}

# The standard error of an estimate on which single trials have `influence`, for participants and
# scenes like these: that of the mixed model of the pairs' influence, as large as the differences
# that the estimate would be the mean of. Without censoring and gaps it is the crossed model's.
crossed_error <- function(rows) {
  pairs <- aggregate(list(difference = rows$influence), rows[c("participant", "scene")], sum)
  pairs$difference <- pairs$difference * nrow(pairs)
  of_pairs <- mixed_model(pairs, "random")
  of_pairs[c("standard_error", "degrees_of_freedom", "participant_sd", "scene_sd")]
}

# The same for participants like these in these scenes: clustered by participant, with the usual
# correction for few clusters (CR1), and t of one degree of freedom fewer than there are.
clustered_error <- function(rows, coefficients) {
  clusters <- nlevels(rows$participant)
  correction <- clusters / (clusters - 1) * (nrow(rows) - 1) / (nrow(rows) - coefficients)
  list(standard_error = sqrt(correction * sum(rowsum(rows$influence, rows$participant)^2)),
       degrees_of_freedom = clusters - 1)
}

# Without participants and scenes all of whose times are right-censored: their terms would be
# infinite, and they say nothing of the ratio.
with_a_measured_time <- function(rows) {
  repeat {
    measured <- rows[!rows$censored, ]
    kept <- droplevels(rows[rows$participant %in% measured$participant &
                              rows$scene %in% measured$scene, ])
    if (nrow(kept) == nrow(rows)) return(kept)
    rows <- kept
  }
}

# A cumulative link mixed model: steps of the scale need not be equal. P and interval are of the
# likelihood ratio, since Wald's fail where the methods' ratings are separated: their odds ratio is
# infinite, and its standard error too. The signed root of the likelihood ratio is scaled and held
# against Student's t as Wald's would be (error_of_latent).
ordinal_model <- function(rows, comparison) {
  rows$rating <- ordered(rows$value)
  rows <- droplevels(rows)
  if (nzchar(why_not(rows))) stop(why_not(rows))
  if (nlevels(rows$rating) < 2) stop("all answers are the same")
  fewest <- 3  # levels of a random effect, for ordinal
  if (nlevels(rows$participant) < fewest) stop("fewer than three participants")
  others <- "(1 | participant)"
  note <- ""
  if (nlevels(rows$scene) > 1) {
    others <- paste(others, "+ (1 | participant:method)")
    if (comparison$scenes == "random" && nlevels(rows$scene) >= fewest) {
      others <- paste(others, "+ (1 | scene) + (1 | scene:method)")
    } else {
      others <- paste("scene +", others)
      if (comparison$scenes == "random") note <- "two scenes are fixed: too few to be random"
    }
  }
  fit <- ordinal::clmm(as.formula(paste("rating ~ method +", others)), data = rows)
  # Returns the root of the likelihood ratio of this log odds ratio.
  root_at <- function(effect) {
    rows$shift <- effect * (rows$method == comparison$method)
    fixed <- ordinal::clmm(as.formula(paste("rating ~ offset(shift) +", others)), data = rows,
                           Hess = FALSE)
    sqrt(max(0, 2 * (fit$logLik - fixed$logLik)))
  }
  row <- coef(summary(fit))[paste0("method", comparison$method), ]
  estimate <- row[["Estimate"]]
  wald <- row[["Std. Error"]]
  # If a far smaller effect, an odds ratio of e^10, is as likely, there is no maximum.
  is_separated <- abs(estimate) > 10 && root_at(sign(estimate) * 10) < 0.2
  if (!is.finite(wald) && !is_separated) stop("the model's Hessian is singular")
  variances <- ordinal::VarCorr(fit)
  # Returns the variance of the difference between two methods.
  of_difference <- function(group) {
    if (group %in% names(variances)) 2 * variances[[group]][1] else NA
  }
  gain <- list(participant = of_difference("participant:method"),
               scene = of_difference("scene:method"))
  error <- if (is_separated) {
    error_without_hessian(gain, counts(rows))
  } else {
    latent <- error_of_latent(wald^2, gain, counts(rows))
    c(latent, scale = latent$standard_error / wald)
  }
  p <- 2 * pt(-root_at(0) / error$scale, error$degrees_of_freedom)
  ends <- if (comparison$detail == "full") {
    limit <- qt((1 + confidence) / 2, error$degrees_of_freedom) * error$scale
    step <- if (is_separated) 2 else limit * wald  # Wald's limit
    c(profile_end(root_at, estimate, -step, limit, is_separated && estimate < 0),
      profile_end(root_at, estimate, step, limit, is_separated && estimate > 0))
  } else {
    c(NA, NA)
  }
  if (any(is.infinite(ends)) && !is_separated) note <- c(note, "the interval has an open end")
  if (is_separated) {
    estimate <- sign(estimate) * Inf
    note <- c(note, "the methods' ratings are separated: the odds ratio has no largest value")
  }
  do.call(result, c(list(comparison, "ordinal", estimate, error$standard_error,
                         error$degrees_of_freedom, low = ends[1], high = ends[2], p = p,
                         status = if (is_separated) "separated" else "fitted",
                         participant_sd = sqrt(gain$participant), scene_sd = sqrt(gain$scene),
                         note = paste(note[nzchar(note)], collapse = "; ")), counts(rows)))
}

# Returns the effect at which root_at(effect) reaches the limit on one side of the estimate;
# infinite if it never does.
profile_end <- function(root_at, estimate, step, limit, is_infinite) {
  if (is_infinite) return(sign(step) * Inf)
  beyond <- function(distance) root_at(estimate + sign(step) * distance) - limit
  distance <- tryCatch(
    uniroot(beyond, c(0, abs(step)), f.lower = -limit, extendInt = "upX",
            tol = 0.01 * abs(step), maxiter = 25)$root,
    error = function(e) Inf)
  estimate + sign(step) * distance
}

# The standard error and Satterthwaite's degrees of freedom of the method's effect by the strata of a
# balanced linear model of the latent variable. ordinal has neither these degrees of freedom nor a
# restricted likelihood, which divides each stratum's sum of squares by them: five scenes would count
# as if their mean were known, and as normally distributed. A stratum without variance of its own is
# pooled with the residual. `variance`: of the estimate; `gain`: of the difference between methods.
error_of_latent <- function(variance, gain, count) {
  levels <- c(count$participants, count$scenes)
  freedom <- levels - 1
  if (count$scenes < 2) {
    return(list(standard_error = sqrt(variance), degrees_of_freedom = freedom[1]))
  }
  parts <- c(gain$participant, gain$scene) / levels
  parts[is.na(parts)] <- 0
  residual <- max(variance - sum(parts), 0)
  varies <- parts > 1e-4 * variance
  if (!any(varies)) {
    of_pairs <- prod(levels) - 1
    return(list(standard_error = sqrt(variance * prod(levels) / of_pairs),
                degrees_of_freedom = of_pairs))
  }
  strata <- ((parts + residual) * levels / freedom)[varies]
  shared <- (length(strata) - 1) * residual
  total <- sum(strata) - shared
  list(standard_error = sqrt(total),
       degrees_of_freedom =
         total^2 / (sum(strata^2 / freedom[varies]) + shared^2 / prod(freedom)))
}

# The same where the Hessian gives no standard error: the latent variable's residual is logistic, of
# the variance pi^2 / 3.
error_without_hessian <- function(gain, count) {
  levels <- c(count$participants, count$scenes)
  variance <- sum(c(gain$participant, gain$scene) / levels, na.rm = TRUE) +
    2 * pi^2 / 3 / prod(levels)
  latent <- error_of_latent(variance, gain, count)
  list(standard_error = NA, degrees_of_freedom = latent$degrees_of_freedom,
       scale = latent$standard_error / sqrt(variance))
}

models_of <- function(trials, comparison) {
  rows <- trials_of(trials, comparison)
  models <- list()
  if (comparison$kind != "points") {
    models$crossed <- guarded(comparison, "crossed", c("lme4", "lmerTest"),
                              function() crossed_model(rows, comparison))
  }
  if (any(rows$censored)) {
    models$tobit <- guarded(comparison, "tobit", c("survival", "lme4", "lmerTest"),
                            function() tobit_model(rows, comparison))
  }
  if (comparison$kind == "points") {
    models$ordinal <- guarded(comparison, "ordinal", "ordinal",
                              function() ordinal_model(rows, comparison))
  }
  do.call(rbind, models)
}

versions <- function() {
  packages <- c("lme4", "lmerTest", "survival", "ordinal")
  have <- packages[vapply(packages, requireNamespace, TRUE, quietly = TRUE)]
  data.frame(name = c("R", have),
             version = c(paste(R.version$major, R.version$minor, sep = "."),
                         vapply(have, function(name) as.character(packageVersion(name)), "")))
}

fit_study <- function(folder) {
  read <- function(name) {
    read.csv(file.path(folder, name), colClasses = "character", na.strings = "",
             check.names = FALSE, encoding = "UTF-8")
  }
  trials <- read("trials_long.csv")
  trials <- trials[trials$status == "analysed", ]
  plan <- read("models_plan.csv")
  fitted <- lapply(seq_len(nrow(plan)), function(i) {
    cat(sprintf("%s, %d of %d: %s, %s against %s\n", folder, i, nrow(plan), plan$measure[i],
                plan$method[i], plan$reference[i]))
    models_of(trials, plan[i, ])
  })
  no_rows <- result(list(measure = "", method = "", reference = "", kind = "time"), "")[0, ]
  write.csv(do.call(rbind, c(list(no_rows), fitted)), file.path(folder, "r_models.csv"),
            row.names = FALSE, na = "")
  write.csv(versions(), file.path(folder, "r_versions.csv"), row.names = FALSE)
}

folders <- commandArgs(trailingOnly = TRUE)
for (folder in if (length(folders) > 0) folders else ".") fit_study(folder)
