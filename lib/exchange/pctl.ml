open Scc_exact
open Scc_property

let ( let* ) = Result.bind

let label named predicates p =
  let same (q : State_predicates.t) = Formula.equal_prop q.prop p in
  match (p : Property.prop) with
  | Bool b -> Ok (string_of_bool b)
  | _ -> (
      match List.find_opt same (Array.to_list predicates) with
      | Some q -> Ok (named q.name)
      | None -> Error "it speaks of events")

let unbounded (b : Property.bound) =
  if Rat.sign b.low = 0 && Option.is_none b.high then Ok () else Error "it has a bound of time"

let rec formula ~named predicates (f : Property.temporal) =
  match Formula.state_formula f with
  | Some p -> label named predicates p
  | None -> (
      let of_part = formula ~named predicates in
      match f with
      | State p -> label named predicates p
      | Temporal_not f ->
        let* f = of_part f in
        Ok (Printf.sprintf "!(%s)" f)
      | Temporal_and fs -> several ~named predicates " & " fs
      | Temporal_or fs -> several ~named predicates " | " fs
      | Next _ -> Error "it has the operator X"
      | Finally (q, b, f) ->
        let* () = unbounded b in
        let* f = of_part f in
        Ok (path q "F" f)
      | Globally (q, b, f) ->
        let* () = unbounded b in
        let* f = of_part f in
        Ok
          (match q with
           | All -> Printf.sprintf "P>=1 [G (%s)]" f
           | Exists -> Printf.sprintf "!(P<1 [G (%s)])" f)
      | Until (q, b, f, g) ->
        let* () = unbounded b in
        let* f = of_part f in
        let* g = of_part g in
        (* Where g begins right after an instant, an instant at which it holds comes after others. *)
        let g = Printf.sprintf "(%s) & ((%s) | !(%s))" g f (named "right_after") in
        Ok (path q (Printf.sprintf "(%s) U" f) g))

(* What ends in a state that is met. *)
and path (q : Property.path_quantifier) operator f =
  match q with
  | All -> Printf.sprintf "P>=1 [%s %s]" operator (bracket f)
  | Exists -> Printf.sprintf "!(P<=0 [%s %s])" operator (bracket f)

and bracket f = "(" ^ f ^ ")"

and several ~named predicates operator fs =
  let add found f =
    let* found = found in
    let* f = formula ~named predicates f in
    Ok (bracket f :: found)
  in
  let* parts = List.fold_left add (Ok []) fs in
  Ok (String.concat operator (List.rev parts))
