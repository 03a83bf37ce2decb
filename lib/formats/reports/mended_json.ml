open Scc_json

let field told =
  let one (by, line) = `Assoc [ ("by", `String by); ("told", Json.text line) ] in
  match told with [] -> [] | _ -> [ ("mended", `List (List.map one told)) ]
