# Verdicts of a model, and the run of its first choices: Rscript oracle.R SCC MODEL
library(jsonlite)

arguments <- commandArgs(trailingOnly = TRUE)
text <- paste(readLines(arguments[2], encoding = "UTF-8"), collapse = "\n")
request <- function(method, params)
  toJSON(list(jsonrpc = "2.0", id = 1, method = method, params = params), auto_unbox = TRUE)
# All lines at once: the first model that is loaded is m1.
answers <- system2(arguments[1], "oracle", stdout = TRUE, input = c(
  request("model.check", list(text = text)),
  request("model.load", list(text = text)),
  request("replay", list(model = "m1", choose = "first"))))
results <- lapply(answers, function(line) {
  answer <- fromJSON(line, simplifyVector = FALSE)
  if (!is.null(answer$error)) stop(answer$error$message)
  answer$result
})
for (check in results[[1]]$properties) cat(check$name, ": ", check$text, "\n", sep = "")
for (line in results[[3]]$lines) {
  if (line$type == "transition") cat(time, " ", line$label$text, "\n", sep = "")
  if (!is.null(line$time)) time <- line$time
}
cat(time, " ", results[[3]]$ending, "\n", sep = "")
