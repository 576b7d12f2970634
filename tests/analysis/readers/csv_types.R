# Opens every CSV file of an analysis with R, as anybody would, and compares each column's type with
# codebook.csv.
#
# Rscript csv_types.R FOLDER
#
# FOLDER is that of `foveola analyze STUDY -o FOLDER`. A column without a single value fits any type.
# Exits with 1 if a column has another type than the codebook says, or if it or its file is not in
# the codebook.

read_file <- function(path) {
  read.csv(path, check.names = FALSE, na.strings = "", encoding = "UTF-8")
}

fits <- function(values, type) {
  switch(type,
    string = is.character(values),
    integer = is.integer(values),
    number = is.numeric(values),
    boolean = is.logical(values),
    FALSE
  )
}

faults_in <- function(path, codebook) {
  file <- basename(path)
  rows <- codebook[codebook$file == sub("[.]csv$", "", file), ]
  data <- read_file(path)
  faults <- character()
  for (name in union(setdiff(names(data), rows$variable), setdiff(rows$variable, names(data)))) {
    faults <- c(faults, paste0(file, ": ", name,
                               ": is in the file or in the codebook, but not in both"))
  }
  for (name in intersect(names(data), rows$variable)) {
    type <- rows$type[rows$variable == name]
    if (!all(is.na(data[[name]])) && !fits(data[[name]], type)) {
      faults <- c(faults, paste0(file, ": ", name, ": the codebook says ", type, ", R reads ",
                                 class(data[[name]])))
    }
  }
  faults
}

folder <- commandArgs(trailingOnly = TRUE)[1]
codebook <- read_file(file.path(folder, "codebook.csv"))
files <- setdiff(list.files(folder, pattern = "[.]csv$"), "codebook.csv")
faults <- unlist(lapply(file.path(folder, files), faults_in, codebook = codebook))
for (name in setdiff(paste0(codebook$file, ".csv"), files)) {
  faults <- c(faults, paste0(name, ": is in the codebook, but not in the folder"))
}
writeLines(c(faults, paste0("R ", getRversion(), ": ", length(files), " files, ", nrow(codebook),
                            " columns, ", length(faults), " faults")))
quit(status = if (length(faults) > 0 || length(files) == 0) 1 else 0)
