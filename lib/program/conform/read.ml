open Scc_base

let trace source =
  let text = Source.text source in
  let n = String.length text in
  let rec first i = if i < n && (text.[i] = ' ' || text.[i] = '\n' || text.[i] = '\r') then first (i + 1) else i in
  let i = first (Source.after_mark text) in
  if i < n && text.[i] = '{' then Json_trace.read source else Csv_trace.read source
