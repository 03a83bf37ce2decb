# Verdicts of a model, and the run of its first choices: Rscript oracle.R SCC MODEL [SECONDS]
# The answers are not waited for longer than so many seconds, 90 unless told.
library(jsonlite)

fail <- function(...) {
  message(...)
  quit(status = 1)
}
arguments <- commandArgs(trailingOnly = TRUE)
seconds <- if (length(arguments) > 2) as.numeric(arguments[3]) else 90
if (length(arguments) < 2 || is.na(seconds)) fail("usage: Rscript oracle.R SCC MODEL [SECONDS]")
if (!file.exists(arguments[2])) fail(arguments[2], ": there is no such file")
text <- paste(readLines(arguments[2], encoding = "UTF-8"), collapse = "\n")
request <- function(method, params)
  toJSON(list(jsonrpc = "2.0", id = 1, method = method, params = params), auto_unbox = TRUE)
# All lines at once: the first model that is loaded is m1.
requests <- c(
  request("model.check", list(text = text)),
  request("model.load", list(text = text)),
  request("replay", list(model = "m1", choose = "first")))
answers <- tryCatch(
  suppressWarnings(system2(arguments[1], "oracle", stdout = TRUE, input = requests, timeout = seconds)),
  error = function(e) fail("scc oracle cannot be started: ", conditionMessage(e)))
results <- lapply(answers, function(line) {
  answer <- tryCatch(fromJSON(line, simplifyVector = FALSE), error = function(e) NULL)
  if (!is.list(answer)) fail("scc oracle has written what is no JSON: ", substr(line, 1, 100))
  if (!is.null(answer$error)) fail(answer$error$message)
  answer$result
})
status <- attr(answers, "status")
if (identical(as.integer(status), 124L)) fail("scc oracle has not answered within ", seconds, " seconds")
if (length(results) < length(requests))
  fail("scc oracle has ended", if (!is.null(status)) paste0(" (exit code ", status, ")"), " before it has answered all")
for (check in results[[1]]$properties) cat(check$name, ": ", check$text, "\n", sep = "")
for (line in results[[3]]$lines) {
  if (line$type == "transition") cat(time, " ", line$label$text, "\n", sep = "")
  if (!is.null(line$time)) time <- line$time
}
cat(time, " ", results[[3]]$ending, "\n", sep = "")
