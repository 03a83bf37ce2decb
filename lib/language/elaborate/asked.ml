open Scc_base
open Scc_calculus

type given = { name : string; attempt : int }
type t = { given : given option; mutable parameter : Open_number.t option }

let create given = { given; parameter = None }

let is t ~name ~also =
  match t.given with
  | None -> false
  | Some given -> List.exists (String.equal given.name) (name :: also)

let found t range =
  let attempt = Option.fold ~none:0 ~some:(fun given -> given.attempt) t.given in
  let parameter = Open_number.parameter range ~attempt in
  t.parameter <- Some parameter;
  parameter

let parameter t = t.parameter

(* Where the name is wrong, the parameter that is meant is one with a range, and stands where ranges cannot. *)
let check t report ~known ~hint =
  match (t.given, t.parameter) with
  | Some { name; _ }, None when not (Report.failed_besides report Code.not_linear) ->
    Report.leave_out report Code.not_linear;
    if known name then
      Report.error report Code.unknown_parameter Span.none "the parameter `%s` has one value, and no range" name
        ~hint:(Printf.sprintf "declare it as in `param %s in (0, 1)`, and give it no value" name)
    else
      Report.error report Code.unknown_parameter Span.none "the model has no parameter `%s`" name ?hint:(hint name)
  | _ -> ()
