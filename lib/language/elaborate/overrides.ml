open Scc_base
open Scc_exact
open Scc_calculus

type given = Value of Rat.t | Within of Ranges.bound * Ranges.bound

(* Of each parameter that is known all names, the global one first; the last parameter first. *)
type t = { given : (string * given) list; asked : Asked.t; mutable known : string list list }

let create ~narrowed ?parametric values =
  let value (name, q) = (name, Value q) and within (name, (low, high)) = (name, Within (low, high)) in
  {
    given = List.append (List.map value values) (List.map within narrowed);
    asked = Asked.create parametric;
    known = [];
  }

let asked t = t.asked

let same_bound (a : Ranges.bound) (b : Ranges.bound) =
  Rat.equal a.value b.value && Bool.equal a.included b.included

(* What is given for one parameter twice: the same, or a value and a range that it is of. *)
let agree name a b =
  match (a, b) with
  | Value p, Value q -> Rat.equal p q
  | Within (a, b), Within (c, d) -> same_bound a c && same_bound b d
  | Value q, Within (low, high) | Within (low, high), Value q -> Ranges.mem { name; low; high } q

let is_value = function _, Value _ -> true | _, Within _ -> false

let given t report ~name ~also =
  let names = name :: List.filter (fun n -> not (String.equal n name)) also in
  t.known <- names :: t.known;
  match List.filter (fun (n, _) -> List.exists (String.equal n) names) t.given with
  | [] -> None
  | all ->
    let values, ranges = List.partition is_value all in
    let first, g = List.hd (values @ ranges) in
    (match List.find_opt (fun (_, other) -> not (agree name g other)) all with
     | Some (second, _) when String.equal first second ->
       Report.error report Code.bad_range Span.none
         "`%s` is given a value that is not in the range given for it" name
     | Some (second, _) ->
       Report.error report Code.unknown_parameter Span.none
         "`%s` and `%s` are one parameter, and have two values" first second
     | None -> ());
    Some g

let value t report ~name ~also =
  match given t report ~name ~also with
  | None -> None
  | Some (Value q) -> Some q
  | Some (Within _) ->
    Report.error report Code.bad_range Span.none "`%s` is a number, and no range narrows it" name
      ~hint:(Printf.sprintf "declare it with a range, as in `param %s in [0, 1]`" name);
    None

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
  List.iter check t.given;
  Asked.check t.asked report ~known:(fun name -> List.exists (List.mem name) t.known) ~hint:(hint t)
