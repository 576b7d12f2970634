# Times to a mark with right-censored ones, and what R's survfit says of them. See README.md.
options(digits = 17)
library(survival)

samples <- data.frame()
values <- data.frame()
note <- function(sample, quantity, value) {
  values <<- rbind(values, data.frame(sample = sample, quantity = quantity, value = unname(value)))
}

set.seed(20180419)
limited <- function(x, limit) cbind(pmin(x, limit), x > limit)
designs <- list(
  all_marked = cbind(signif(rlnorm(16, 2, 0.7), 6), 0),
  all_censored = cbind(c(180, 180, 180, 120, 90), 1),
  ties = cbind(c(3, 3, 3, 5, 5, 8, 8, 8, 8, 11, 12, 12, 20), c(0, 0, 1, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0)),
  last_censored = cbind(c(2.5, 4, 4, 7.25, 9, 10, 13), c(0, 0, 1, 0, 1, 0, 1)),
  flat_at_half = cbind(c(1, 2, 4, 9), 0),
  flat_at_half_to_the_end = cbind(c(1, 2, 4, 9), c(0, 0, 1, 1)),
  one_marked = cbind(7, 0),
  first_censored = cbind(c(1, 2, 2, 3), c(1, 0, 0, 0)),
  limit_13_percent = limited(signif(rlnorm(80, 4, 1.05), 5), 180),
  limit_50_percent = limited(signif(rlnorm(80, 5.2, 0.8), 5), 180))
for (name in names(designs)) {
  x <- designs[[name]]
  samples <- rbind(samples, data.frame(sample = name, row = rep(seq_len(nrow(x)), 2),
                                       column = rep(1:2, each = nrow(x)), value = as.vector(x)))
  fit <- survfit(Surv(x[, 1], 1 - x[, 2]) ~ 1, conf.type = "log-log")
  steps <- summary(fit, censored = TRUE)
  note(name, "n", fit$n)
  note(name, "events", sum(fit$n.event))
  note(name, "steps", length(fit$time))
  for (i in seq_along(fit$time)) {
    of_step <- function(quantity) paste(quantity, i, sep = "_")
    note(name, of_step("time"), fit$time[i])
    note(name, of_step("at_risk"), fit$n.risk[i])
    note(name, of_step("events"), fit$n.event[i])
    note(name, of_step("censored"), fit$n.censor[i])
    note(name, of_step("survival"), fit$surv[i])
    note(name, of_step("standard_error"), steps$std.err[i])
    note(name, of_step("low"), fit$lower[i])
    note(name, of_step("high"), fit$upper[i])
  }
  table <- steps$table
  note(name, "median", table["median"])
  note(name, "median_low", table["0.95LCL"])
  note(name, "median_high", table["0.95UCL"])
  for (horizon in c(6, 8, 20, 180)) {
    if (horizon < min(x[, 1])) next # R refuses
    mean <- summary(fit, rmean = horizon)$table
    note(name, paste("mean", horizon, sep = "_"), mean["rmean"])
    note(name, paste("mean_error", horizon, sep = "_"), mean["se(rmean)"])
  }
}

exact <- function(x) sprintf("%.17g", x)
samples$value <- exact(samples$value)
values <- values[!is.na(values$value), ] # what is not defined has no row
values$value <- exact(values$value)
write.csv(samples, "survival_samples.csv", row.names = FALSE, quote = FALSE)
write.csv(values, "survival_values.csv", row.names = FALSE, quote = FALSE)
cat("survival", as.character(packageVersion("survival")), "\n")
