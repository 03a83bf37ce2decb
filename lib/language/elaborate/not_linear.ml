open Scc_base
open Scc_calculus

let hint names =
  match names with
  | [] -> None
  | name :: _ ->
    Some
      (Printf.sprintf
         "`-D %s=VALUE` gives it a value; ranges may stand in places and delays, in sums and multiples, and in \
          weights and chances with `--parametric %s`"
         name name)

let listed names = String.concat ", " (List.map (Printf.sprintf "`%s`") names)

let needed_at (at : Span.t) = function
  | Some (span : Span.t) when not (span.start <= at.start && at.stop <= span.stop) ->
    [ (span, "it is needed here") ]
  | Some _ | None -> []

let report report ?needed at ~why form =
  let names = Form.names form in
  let notes = needed_at at needed in
  let known = match names with [ _ ] -> "is known by its range" | _ -> "are known by their ranges" in
  Report.error report Code.not_linear at ?hint:(hint names) ~notes "%s %s alone, and cannot stand here: %s"
    (listed names) known why

let refuse report ?needed at ~why (n : Open_number.t) =
  Report.error report Code.not_linear at ~notes:(needed_at at needed)
    ~hint:"with `--parametric` it may stand in weights and chances"
    "`%s` is the parameter that is asked about, and cannot stand here: %s" n.parameter.name why
