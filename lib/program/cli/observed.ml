open Scc_base
open Scc_loading
open Scc_export

let all console (l : Loaded.t) texts =
  let source i = Input.given console ~name:(Printf.sprintf "<observable %d>" (i + 1)) in
  let sources = List.mapi source texts in
  let observable source : Question.t -> (Table.observable, Diag.t list) result = function
    | Number n -> Ok { Table.text = Source.text source; what = Number n }
    | State p -> Ok { Table.text = Source.text source; what = Truth p }
    | Temporal check ->
      let at = Span.make ~file:(Source.name source) ~start:0 ~stop:(String.length (Source.text source)) in
      Error
        [
          Diag.error Code.type_mismatch at ~hint:"`scc check` decides it"
            "%s is a formula about runs: a number or a predicate of a state is needed here" check.text;
        ]
  in
  let* l, questions = if texts = [] then Ok (l, []) else Question.all l sources in
  let rec all found = function
    | [], _ | _, [] -> Ok (l, List.rev found)
    | source :: sources, question :: questions ->
      let* o = observable source question in
      all (o :: found) (sources, questions)
  in
  all [] (sources, questions)
