# A made-up study with gaps, and its tables by R. See README.md.
#
# P01 ... P08 are complete but for: P02 has no trial (aula, vp); P03's od times in aula timed out;
# P04 has no material time in (barn, fv); P05 has no rating in (cave, od). P09 was interrupted.
options(digits = 17)
set.seed(2018)

participants <- sprintf("P%02d", 1:9)
scenes <- c("aula", "barn", "cave")
methods <- c("od", "vp", "fv")
trials <- expand.grid(method = methods, scene = scenes, participant = participants,
                      stringsAsFactors = FALSE)[, c("participant", "scene", "method")]
factor_of <- c(od = 1, vp = 0.32, fv = 0.1)
seconds_of <- c(aula = 8, barn = 15, cave = 26)
speed <- setNames(exp(rnorm(9, 0, 0.3)), participants)
noise <- function() exp(rnorm(nrow(trials), 0, 0.2))
base <- seconds_of[trials$scene] * factor_of[trials$method] * speed[trials$participant]
trials$outline_s <- round(base * noise(), 4)
trials$material_s <- round(trials$outline_s + 0.7 * base * noise(), 4)
trials$outline_censored <- 0
trials$material_censored <- 0
trials$rating <- pmin(5, pmax(1, round(rnorm(nrow(trials), c(od = 1.4, vp = 1.9, fv = 2.4)[trials$method], 0.8))))

at <- function(p, s, m) trials$participant == p & trials$scene == s & trials$method == m
trials[at("P03", "aula", "od"), c("outline_s", "material_s")] <- 60
trials[at("P03", "aula", "od"), c("outline_censored", "material_censored")] <- 1
trials[at("P04", "barn", "fv"), "material_s"] <- NA
trials[at("P05", "cave", "od"), "rating"] <- NA
trials <- trials[!at("P02", "aula", "vp"), ]
background <- expand.grid(question = c("offline_rendering", "graphics_3d", "virtual_reality"),
                          participant = participants, stringsAsFactors = FALSE)[, 2:1]
background$value <- sample(1:5, nrow(background), replace = TRUE)

values <- data.frame()
note <- function(key, value) {
  values <<- rbind(values, data.frame(key = paste(key, collapse = "."), value = unname(value)))
}

complete <- trials[trials$participant != "P09", ]
wide <- function(mark) {
  rows <- complete
  rows$time <- ifelse(rows[[paste0(mark, "_censored")]] == 1, NA, rows[[paste0(mark, "_s")]])
  xtabs_names <- list(unique(rows$participant), scenes, methods)
  cube <- array(NA_real_, dim = c(8, 3, 3), dimnames = xtabs_names)
  cube[cbind(rows$participant, rows$scene, rows$method)] <- rows$time
  cube
}

for (mark in c("outline", "material")) {
  cube <- wide(mark)
  for (s in scenes) for (m in methods) {
    x <- na.omit(cube[, s, m])
    note(c(mark, s, m, "n"), length(x))
    note(c(mark, s, m, "mean_s"), mean(x))
    note(c(mark, s, m, "sd_s"), sd(x))
    if (m != "od") {
      percent <- na.omit(100 * cube[, s, m] / cube[, s, "od"])
      note(c(mark, s, m, "n_pairs"), length(percent))
      note(c(mark, s, m, "mean_percent"), mean(percent))
      note(c(mark, s, m, "sd_percent"), sd(percent))
      ratio <- t.test(log(percent))
      note(c(mark, s, m, "geometric_percent"), exp(ratio$estimate))
      note(c(mark, s, m, "geometric_percent_low"), exp(ratio$conf.int[1]))
      note(c(mark, s, m, "geometric_percent_high"), exp(ratio$conf.int[2]))
      od_mean <- mean(na.omit(cube[, s, "od"]))
      note(c(mark, s, m, "ratio_of_means_percent"), 100 * mean(x) / od_mean)
      note(c(mark, s, m, "sd_percent_points"), 100 * sd(x) / od_mean)
    }
  }
  incomplete <- apply(is.na(cube), 1:2, any)
  logs <- log(cube)
  saved <- list()
  for (m in methods) {
    by_participant <- sapply(rownames(cube), function(p) mean(logs[p, !incomplete[p, ], m]))
    od <- sapply(rownames(cube), function(p) mean(logs[p, !incomplete[p, ], "od"]))
    test <- t.test(by_participant)
    note(c(mark, m, "geometric_mean_s"), exp(test$estimate))
    note(c(mark, m, "low_s"), exp(test$conf.int[1]))
    note(c(mark, m, "high_s"), exp(test$conf.int[2]))
    if (m != "od") {
      ratio <- t.test(by_participant, od, paired = TRUE)
      note(c(mark, m, "geometric_mean_percent"), 100 * exp(ratio$estimate))
      note(c(mark, m, "low_percent"), 100 * exp(ratio$conf.int[1]))
      note(c(mark, m, "high_percent"), 100 * exp(ratio$conf.int[2]))
      saved <- sapply(rownames(cube), function(p)
        mean(cube[p, !incomplete[p, ], "od"] - cube[p, !incomplete[p, ], m]))
      experience <- sapply(rownames(cube), function(p)
        mean(background$value[background$participant == p & background$question != "virtual_reality"]))
      correlation <- cor.test(experience, saved)
      note(c(mark, m, "r"), correlation$estimate)
      note(c(mark, m, "p"), correlation$p.value)
      note(c(mark, m, "r_low"), correlation$conf.int[1])
      note(c(mark, m, "r_high"), correlation$conf.int[2])
      of_logs <- cor.test(experience, od - by_participant)
      note(c(mark, m, "log_r"), of_logs$estimate)
      note(c(mark, m, "log_p"), of_logs$p.value)
      note(c(mark, m, "log_r_low"), of_logs$conf.int[1])
      note(c(mark, m, "log_r_high"), of_logs$conf.int[2])
    }
  }
}
for (m in methods) {
  ratings <- na.omit(complete$rating[complete$method == m])
  note(c("rating", m, "n"), length(ratings))
  note(c("rating", m, "mean"), mean(ratings))
  note(c("rating", m, "sd"), sd(ratings))
  note(c("rating", m, "median"), median(ratings))
  for (answer in 1:5) note(c("rating", m, paste0("count_", answer)), sum(ratings == answer))
}

exact <- function(x) ifelse(is.na(x), "", sprintf("%.17g", x))
for (column in c("outline_s", "material_s", "rating")) trials[[column]] <- exact(trials[[column]])
values$value <- exact(values$value)
write.csv(trials, "study_trials.csv", row.names = FALSE, quote = FALSE)
write.csv(background, "study_background.csv", row.names = FALSE, quote = FALSE)
write.csv(values, "study_values.csv", row.names = FALSE, quote = FALSE)
