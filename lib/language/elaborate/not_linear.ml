open Scc_base

let hint names =
  match names with
  | [] -> None
  | name :: _ ->
    Some
      (Printf.sprintf
         "`-D %s=VALUE` gives it a value; ranges may stand in places and delays, in sums and multiples" name)

let listed names = String.concat ", " (List.map (Printf.sprintf "`%s`") names)

let report report ?needed at ~why form =
  let names = Form.names form in
  let notes =
    match needed with
    | Some (span : Span.t) when not (span.start <= at.Span.start && at.stop <= span.stop) ->
      [ (span, "it is needed here") ]
    | Some _ | None -> []
  in
  let known = match names with [ _ ] -> "is known by its range" | _ -> "are known by their ranges" in
  Report.error report Code.not_linear at ?hint:(hint names) ~notes "%s %s alone, and cannot stand here: %s"
    (listed names) known why
