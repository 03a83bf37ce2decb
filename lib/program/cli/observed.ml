open Scc_base
open Scc_loading
open Scc_export

let questions console l texts ~name meant =
  let sources = List.mapi (fun i text -> Input.given console ~name:(name i text) text) texts in
  let* l, questions = if texts = [] then Ok (l, []) else Question.all l sources in
  let one (i, source, question) =
    let refuse code ?hint why =
      let at = Span.make ~file:(Source.name source) ~start:0 ~stop:(String.length (Source.text source)) in
      Error [ Diag.error code at ?hint "%s" why ]
    in
    meant i source question ~refuse
  in
  let numbered = List.mapi (fun i (source, question) -> (i, source, question)) (List.combine sources questions) in
  Result.map (fun found -> (l, found)) (Result.all one numbered)

let all console l texts =
  questions console l texts ~name:(fun i _ -> Printf.sprintf "<observable %d>" (i + 1))
    (fun _ source question ~refuse ->
       match question with
       | Number n -> Ok { Table.text = Source.text source; what = Number n }
       | State p -> Ok { Table.text = Source.text source; what = Truth p }
       | Temporal check ->
         refuse Code.type_mismatch ~hint:"`scc check` decides it"
           (check.text ^ " is a formula about runs: a number or a predicate of a state is needed here"))
