# Samples and what R says about them. See README.md.
options(digits = 17)

single <- function(name, x) data.frame(sample = name, x = x, y = NA)
paired <- function(name, x, y) data.frame(sample = name, x = x, y = y)

set.seed(20180416)
lognormal <- signif(rlnorm(16, 2, 0.7), 6)
strong_x <- signif(rnorm(200), 6)
strong_y <- signif(2 * strong_x + 0.1 * rnorm(200), 6)
many_x <- signif(rnorm(1000, 1e9, 1), 15)
many_y <- signif(-0.3 * (many_x - 1e9) + rnorm(1000), 6)

samples <- rbind(
  single("sauro", c(55, 65, 75, 62, 45, 135)),
  single("two", c(3.5, 7.25)),
  single("constant", rep(0.1, 7)),
  single("offset", 1e9 + c(1.5, 2.25, 3, 4.5, 9.75)),
  single("lognormal", lognormal),
  single("huge", c(1e300, 2.5e300, 3e300, 7e300)),
  single("tiny", c(1e-300, 2.5e-300, 3e-300, 7e-300)),
  single("even_ties", c(1, 1, 2, 2, 3, 3, 3, 5)),
  paired("three", c(1, 2, 4), c(2.5, 2, 7)),
  paired("four", c(1, 2, 4, 3), c(2.5, 2, 7, -1)),
  paired("sixteen", lognormal, rev(lognormal)),
  paired("ties", c(1, 1, 2, 2, 3, 3, 3, 5, 4, 4), c(5, 4, 4, 4, 3, 3, 2, 1, 1, 2)),
  paired("strong", strong_x, strong_y),
  paired("many_offset", many_x, many_y),
  paired("tiny_pairs", 1e-200 * c(1, 2, 3, 4, 5.5), 1e-200 * c(1.5, 1, 4, 3, 6)))

values <- data.frame()
note <- function(sample, quantity, value) {
  values <<- rbind(values, data.frame(sample = sample, quantity = quantity, value = value))
}

# R squares doubles: the largest and smallest are taken in units of the largest value.
unit_of <- function(x) if (max(x) > 1e100 || max(x) < 1e-100) max(x) else 1

for (name in unique(samples$sample)) {
  rows <- samples[samples$sample == name, ]
  x <- rows$x
  if (all(is.na(rows$y))) {
    unit <- unit_of(x)
    note(name, "n", length(x))
    note(name, "mean", mean(x))
    note(name, "standard_deviation", sd(x / unit) * unit)
    note(name, "median", median(x))
    note(name, "geometric_mean", exp(mean(log(x))))
    if (sd(x / unit) > 0) {
      interval <- exp(t.test(log(x))$conf.int)
      note(name, "geometric_mean_low", interval[1])
      note(name, "geometric_mean_high", interval[2])
    }
  } else {
    y <- rows$y
    test <- cor.test(x / unit_of(x), y / unit_of(y))
    note(name, "n", length(x))
    note(name, "r", test$estimate)
    note(name, "t", test$statistic)
    note(name, "p", test$p.value)
    if (!is.null(test$conf.int)) {
      note(name, "r_low", test$conf.int[1])
      note(name, "r_high", test$conf.int[2])
    }
  }
}
for (df in c(1, 2, 15, 1000)) {
  note(paste0("t", df), "quantile_95", qt(0.975, df))
  note(paste0("t", df), "two_sided_of_3", 2 * pt(-3, df))
}
note("t30", "two_sided_of_1e10", 2 * pt(-1e10, 30))
note("t400", "two_sided_of_80", 2 * pt(-80, 400))

exact <- function(x) ifelse(is.na(x), "", sprintf("%.17g", x))
samples$x <- exact(samples$x)
samples$y <- exact(samples$y)
values$value <- exact(values$value)
write.csv(samples, "statistics_samples.csv", row.names = FALSE, quote = FALSE)
write.csv(values, "statistics_values.csv", row.names = FALSE, quote = FALSE)
