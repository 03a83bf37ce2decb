open Scc_base
open Scc_exact

(* Of each parameter that is known all names, the global one first; the last parameter first. *)
type t = { given : (string * Rat.t) list; mutable known : string list list }

let create given = { given; known = [] }

let value t report ~name ~also =
  let names = name :: List.filter (fun n -> not (String.equal n name)) also in
  t.known <- names :: t.known;
  match List.filter (fun (n, _) -> List.exists (String.equal n) names) t.given with
  | [] -> None
  | (first, q) :: others ->
    let differs (_, q') = not (Rat.equal q q') in
    (match List.find_opt differs others with
     | Some (second, _) ->
       Report.error report Code.unknown_parameter Span.none
         "`%s` and `%s` are one parameter, and have two values" first second
     | None -> ());
    Some q

let listed names = String.concat " or " (List.map (Printf.sprintf "`%s`") names)

(* More of them would hide what is said. *)
let most_listed = 10

let hint t name =
  match (Diag.suggest name (List.concat (List.rev t.known)), t.known) with
  | Some hint, _ -> Some hint
  | None, [] -> None
  | None, known when List.length known > most_listed -> None
  | None, known -> Some ("its parameters: " ^ String.concat ", " (List.rev_map listed known))

let check t report at =
  let check (name, _) =
    match List.filter (List.exists (String.equal name)) t.known with
    | [ _ ] -> ()
    | [] ->
      Report.error report Code.unknown_parameter at "the model has no parameter `%s`" name ?hint:(hint t name)
    | several ->
      Report.error report Code.unknown_parameter at
        "`%s` can be more than one parameter; reports call them %s" name
        (String.concat " and " (List.rev_map (fun names -> listed [ List.hd names ]) several))
        ~hint:"call an import otherwise, with `as`"
  in
  List.iter check t.given
