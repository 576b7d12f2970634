# Samples for tests, intervals and planning, and what R says about them. See README.md.
options(digits = 17, contrasts = c("contr.sum", "contr.poly"))
suppressMessages({
  library(boot)
  library(coin)
  library(exactRankTests)
})

samples <- data.frame()
values <- data.frame()
# A sample is a matrix: a row for each participant, a column for each condition.
keep <- function(name, x) {
  x <- as.matrix(x)
  samples <<- rbind(samples, data.frame(sample = name, row = rep(seq_len(nrow(x)), ncol(x)),
                                        column = rep(seq_len(ncol(x)), each = nrow(x)),
                                        value = as.vector(x)))
  invisible(unname(x))
}
note <- function(sample, quantity, value) {
  values <<- rbind(values, data.frame(sample = sample, quantity = quantity, value = unname(value)))
}
# R squares doubles: the largest and smallest are taken in units of the largest value.
unit_of <- function(x) if (max(abs(x)) > 1e100 || max(abs(x)) < 1e-100) max(abs(x)) else 1

set.seed(20180416)
n <- 16
person <- rnorm(n, 0, 0.4)
times <- signif(exp(outer(person, log(c(12, 4, 1.3)), "+") + rnorm(3 * n, 0, 0.25)), 6)
ratings <- function(rows, columns) matrix(sample(1:5, rows * columns, replace = TRUE), rows)

# Every order of y's ranks; the same as R's own where nothing is tied.
orders <- function(y) if (length(y) < 2) list(y) else
  unlist(lapply(seq_along(y), function(i) lapply(orders(y[-i]), function(rest) c(y[i], rest))), FALSE)
exact_spearman <- function(x, y) {
  a <- rank(x)
  sums <- sapply(orders(rank(y)), function(b) sum(a * b))
  found <- min(1, 2 * min(mean(sums <= sum(a * rank(y))), mean(sums >= sum(a * rank(y)))))
  if (!anyDuplicated(x) && !anyDuplicated(y)) {
    stopifnot(abs(cor.test(x, y, method = "spearman", exact = TRUE)$p.value / found - 1) < 1e-12)
  }
  found
}

# Differences within participants ---------------------------------------------------------------
strong <- signif(cbind(rnorm(400, 4, 1), rnorm(400, 0, 0.1)), 8)
pairs <- list(
  times = times[, c(3, 1)], pair_of_two = rbind(c(3.5, 2), c(7.25, 9)),
  likert = ratings(16, 2), likert_many = ratings(60, 2), few_ties = cbind(c(1, 2, 4, 4, 6, 9, 3), 3),
  half = cbind(c(0.5, 1.5, 2.5, 3.5, 4.5, 5.5), 0), offset = 1e9 + ratings(12, 2) + c(0.25, 0.5, 0.75),
  huge = 1e300 * cbind(c(1, 2.5, 3, 7), c(2, 2, 4, 5)), tiny = 1e-300 * cbind(c(1, 2.5, 3, 7), c(2, 2, 4, 5)),
  strong = strong)
for (name in names(pairs)) {
  x <- keep(name, pairs[[name]])
  d <- x[, 1] - x[, 2]
  unit <- unit_of(x)
  d <- x[, 1] / unit - x[, 2] / unit
  test <- t.test(d)
  note(name, "t", test$statistic)
  note(name, "p", test$p.value)
  note(name, "low", test$conf.int[1] * unit)
  note(name, "high", test$conf.int[2] * unit)
  note(name, "d_z", mean(d) / sd(d))
  margin <- 1.5 * sd(d)
  equivalent <- c(t.test(d, mu = -margin, alternative = "greater")$p.value,
                  t.test(d, mu = margin, alternative = "less")$p.value)
  note(name, "margin", margin * unit)
  note(name, "p_above_low", equivalent[1])
  note(name, "p_below_high", equivalent[2])
  ninety <- t.test(d, conf.level = 0.9)$conf.int * unit
  note(name, "low_90", ninety[1])
  note(name, "high_90", ninety[2])
  note(name, "zeros", sum(d == 0))
  note(name, "w_plus", suppressWarnings(wilcox.test(d)$statistic))
  note(name, "p_approximate", suppressWarnings(wilcox.test(d, exact = FALSE)$p.value))
  if (length(d) <= 60) {
    note(name, "p_exact", wilcox.exact(d, exact = TRUE)$p.value)
    pratt <- wilcoxsign_test(I(x[, 1] / unit) ~ I(x[, 2] / unit), distribution = "exact", zero.method = "Pratt")
    note(name, "p_exact_pratt", as.numeric(pvalue(pratt)))
  }
  if (all(x > 0)) {
    ratio <- t.test(log(x[, 1]) - log(x[, 2]))
    note(name, "ratio", exp(ratio$estimate))
    note(name, "ratio_low", exp(ratio$conf.int[1]))
    note(name, "ratio_high", exp(ratio$conf.int[2]))
    note(name, "ratio_p", ratio$p.value)
  }
  walsh <- sort((outer(d, d, "+") / 2)[upper.tri(diag(length(d)), diag = TRUE)])
  note(name, "pseudo_median", median(walsh) * unit)
  lowest <- qsignrank(0.025, length(d))
  if (lowest > 0 && length(d) <= 60) {
    note(name, "pseudo_median_low", walsh[lowest] * unit)
    note(name, "pseudo_median_high", rev(walsh)[lowest] * unit)
    if (!any(d == 0) && !anyDuplicated(abs(d))) { # the same by R's own
      own <- wilcox.test(d, conf.int = TRUE, exact = TRUE)
      stopifnot(own$estimate == median(walsh), own$conf.int == c(walsh[lowest], rev(walsh)[lowest]))
    }
  }
  rho <- suppressWarnings(cor.test(x[, 1], x[, 2], method = "spearman", exact = FALSE))
  if (!is.na(rho$estimate) && nrow(x) > 3) {
    note(name, "rho", rho$estimate)
    note(name, "rho_p", rho$p.value)
    width <- qnorm(0.975) * sqrt((1 + rho$estimate^2 / 2) / (nrow(x) - 3))
    note(name, "rho_low", tanh(atanh(rho$estimate) - width))
    note(name, "rho_high", tanh(atanh(rho$estimate) + width))
    if (nrow(x) <= 9) note(name, "rho_p_exact", exact_spearman(x[, 1], x[, 2]))
  }
}

# Several conditions ------------------------------------------------------------------------------
gaps <- signif(exp(outer(person, c(2, 1, 0, 0.5), "+") + rnorm(4 * n, 0, 0.3)), 6)
gaps[2, 3] <- gaps[9, 1] <- gaps[9, 4] <- NA
blocks <- list(
  log_times = log(times), likert_three = ratings(16, 3), likert_five = ratings(9, 5), gaps = gaps,
  two_people = rbind(c(1, 4, 2), c(2, 3, 5)), two_conditions = log(times[, 1:2]),
  offset_three = 1e9 + round(times, 2), tiny_three = 1e-300 * times,
  clear = signif(outer(rnorm(60), c(0, 28, 56), "+") + rnorm(180, 0, 0.1), 10))
for (name in names(blocks)) {
  x <- keep(name, blocks[[name]])
  x <- x[complete.cases(x), , drop = FALSE]
  x <- x / unit_of(x)
  # Free of large offsets, which do not matter to what follows.
  x <- x - floor(min(x))
  long <- data.frame(y = as.vector(x), condition = factor(col(x)), person = factor(row(x)))
  table <- summary(aov(y ~ condition + Error(person / condition), long))[["Error: person:condition"]][[1]]
  f <- table[1, "F value"]
  df <- table[, "Df"]
  k <- ncol(x)
  m <- diag(k) - 1 / k
  s <- m %*% cov(x) %*% m
  epsilon <- min(1, sum(diag(s))^2 / ((k - 1) * sum(s * s)))
  if (nrow(x) > k && k > 2) { # the same by R's own
    own <- anova(lm(x ~ 1), X = ~1, test = "Spherical")
    stopifnot(abs(own[1, "F"] / f - 1) < 1e-8,
              abs(own[1, "G-G Pr"] - pf(f, epsilon * df[1], epsilon * df[2], lower.tail = FALSE)) < 1e-10)
  }
  note(name, "f", f)
  note(name, "f_p", pf(f, df[1], df[2], lower.tail = FALSE))
  note(name, "epsilon", epsilon)
  note(name, "f_p_gg", pf(f, epsilon * df[1], epsilon * df[2], lower.tail = FALSE))
  corrected <- if (nrow(x) == 2) epsilon else
    min(1, (nrow(x) * (k - 1) * epsilon - 2) / ((k - 1) * (nrow(x) - 1 - (k - 1) * epsilon)))
  if (nrow(x) > k && k > 2) {
    stopifnot(abs(own[1, "H-F Pr"] - pf(f, corrected * df[1], corrected * df[2], lower.tail = FALSE)) < 1e-10)
  }
  note(name, "huynh_feldt", corrected)
  note(name, "f_p_hf", pf(f, corrected * df[1], corrected * df[2], lower.tail = FALSE))
  note(name, "partial_eta_squared", table[1, "Sum Sq"] / sum(table[, "Sum Sq"]))
  ranked <- friedman.test(x)
  note(name, "chi_squared", ranked$statistic)
  note(name, "chi_squared_p", ranked$p.value)
  note(name, "kendalls_w", ranked$statistic / (nrow(x) * (k - 1)))
}

# Orders of few -----------------------------------------------------------------------------------
few <- list(ranks_of_nine = cbind(c(3, 1, 4, 15, 9, 2, 6, 5, 35), c(2, 7, 18, 28, 1, 8, 3, 14, 16)),
  ranks_with_ties = cbind(c(1, 2, 2, 3, 5, 5, 5), c(2, 1, 4, 4, 3, 9, 7)),
  ranks_of_three = cbind(c(1, 2, 3), c(1, 3, 2)), ranks_alike = cbind(1:6, c(2, 4, 8, 16, 32, 64)),
  ranks_offset = cbind(1e9 + c(0.5, 0.25, 0.75, 1, 1.25), c(1, 2, 3, 4, 4)))
for (name in names(few)) {
  x <- keep(name, few[[name]])
  note(name, "rho_p_exact", exact_spearman(x[, 1], x[, 2]))
}

# Several P-values --------------------------------------------------------------------------------
p <- keep("p_values", c(0.01, 0.04, 0.03, 0.005, 0.04, 1e-300, 0.9, 1))
for (i in seq_along(p)) note("p_values", paste0("holm_", i), p.adjust(p, "holm")[i])

# Order -------------------------------------------------------------------------------------------
order_data <- data.frame()
for (i in 1:8) {
  position <- sample(0:8)
  order_data <- rbind(order_data, data.frame(person = i, condition = 1:9, position = position,
    value = signif(person[i] + (1:9) / 4 - 0.05 * position + rnorm(9, 0, 0.1), 8)))
}
order_data <- order_data[-c(3, 40), ]
x <- keep("order", order_data)
# Free of what people and conditions are like on average.
centered <- function(v) resid(lm(v ~ factor(order_data$person) + factor(order_data$condition)))
order_data$x <- centered(order_data$position)
order_data$y <- centered(order_data$value)
slopes <- sapply(split(order_data, order_data$person), function(r) coef(lm(y ~ x, r))[2])
test <- t.test(slopes)
note("order", "mean", test$estimate)
note("order", "t", test$statistic)
note("order", "p", test$p.value)

# The bootstrap: R's quantiles of replicates that both programs are given ---------------------------
x <- keep("bootstrap", signif(rexp(16), 6))
replicated <- boot(x[, 1], function(v, i) mean(v[i]), R = 999)
keep("bootstrap_replicates", replicated$t)
jackknife <- sapply(1:16, function(i) mean(x[-i, 1]))
ci <- boot.ci(replicated, conf = c(0.9, 0.95), type = "bca", L = 15 * (mean(jackknife) - jackknife))
note("bootstrap", "low_90", ci$bca[1, 4])
note("bootstrap", "high_90", ci$bca[1, 5])
note("bootstrap", "low_95", ci$bca[2, 4])
note("bootstrap", "high_95", ci$bca[2, 5])

# Proportions and planning --------------------------------------------------------------------------
for (case in list(c(0, 10), c(10, 10), c(3, 16), c(200, 4000), c(1, 1))) {
  interval <- binom.test(case[1], case[2])$conf.int
  note(paste("proportion", case[1], case[2], sep = "_"), "low", interval[1])
  note(paste("proportion", case[1], case[2], sep = "_"), "high", interval[2])
}
for (case in list(c(2, 1), c(16, 0.25), c(16, 0.8), c(30, 0.5), c(100, 0.1), c(5, 3))) {
  note(paste("power", case[1], case[2], sep = "_"), "power",
       power.t.test(n = case[1], delta = case[2], sd = 1, type = "paired", strict = TRUE)$power)
}
for (delta in c(0.1, 0.5, 0.8, 2)) {
  note(paste("planning", delta, sep = "_"), "n",
       ceiling(power.t.test(power = 0.9, delta = delta, sd = 1, type = "paired", strict = TRUE,
                            tol = 1e-10)$n))
}
note("tails", "normal_30", 2 * pnorm(-30))
note("tails", "normal_37", 2 * pnorm(-37))
note("tails", "f_1e5", pf(1e5, 2, 118, lower.tail = FALSE))
note("tails", "t_30_df_15", pt(-30, 15))
note("tails", "t_1e60_df_5", 2 * pt(-1e60, 5))
note("tails", "chi_squared_1380", pchisq(1380, 2, lower.tail = FALSE))

exact <- function(x) ifelse(is.na(x), "", sprintf("%.17g", x))
samples$value <- exact(samples$value)
values$value <- exact(values$value)
write.csv(samples, "inference_samples.csv", row.names = FALSE, quote = FALSE)
write.csv(values, "inference_values.csv", row.names = FALSE, quote = FALSE)
for (package in c("boot", "coin", "exactRankTests")) {
  cat(package, as.character(packageVersion(package)), "\n")
}
