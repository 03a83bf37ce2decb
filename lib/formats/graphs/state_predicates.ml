open Scc_exact
open Scc_property

type t = { name : string; text : string; prop : Property.prop }

let reserved = [ "init"; "deadlock"; "quiescent"; "unexplored"; "right_after" ]
let about_states prop = not (Formula.has_events (State prop))

(* The greatest subformulas without temporal operators, newest first. *)
let rec greatest found (f : Property.temporal) =
  match Formula.state_formula f with
  | Some p -> if about_states p then p :: found else found
  | None -> List.fold_left greatest found (Parts.of_temporal f)

(* What needs no label of its own. *)
let has_label : Property.prop -> bool = function Bool _ | Fact Quiescent -> true | _ -> false

let of_checks model (checks : Property.check list) =
  let speaks_of_states (c : Property.check) =
    match c.asked with Whether | How_likely _ | Expected (_, Time_until _, _) -> true | Expected _ -> false
  in
  let checks = List.filter speaks_of_states checks in
  let wholes = List.map (fun (c : Property.check) -> (c, List.rev (greatest [] c.formula))) checks in
  let add found p =
    if has_label p || List.exists (Formula.equal_prop p) found then found else p :: found
  in
  let atoms =
    List.fold_left
      (fun found (_, props) ->
         List.fold_left (fun found p -> List.fold_left add found (Show.atoms p)) found props)
      [] wholes
    |> List.rev
  in
  let names = Safe_names.make ~reserved in
  let atom prop =
    let text = Show.prop model prop in
    { name = Safe_names.name names text; text; prop }
  in
  let atoms = List.map atom atoms in
  let whole ((c : Property.check), props) =
    List.mapi
      (fun i prop ->
         let wanted = if i = 0 then "check_" ^ c.name else Printf.sprintf "check_%s_%d" c.name (i + 1) in
         { name = Safe_names.name names wanted; text = Show.prop model prop; prop })
      props
  in
  atoms @ List.concat_map whole wholes

type aim = Reached of Property.prop | Kept of Property.prop

let rec aim (f : Property.temporal) =
  let unbounded (b : Property.bound) = Rat.sign b.low = 0 && Option.is_none b.high in
  let of_state b g make =
    match Formula.state_formula g with
    | Some p when unbounded b && about_states p -> [ make p ]
    | _ -> []
  in
  match f with
  | Finally ((All | Exists), b, g) -> of_state b g (fun p -> Reached p)
  | Globally (All, b, g) -> of_state b g (fun p -> Kept p)
  | Temporal_and fs -> List.concat_map aim fs
  | State _ | Temporal_not _ | Temporal_or _ | Next _ | Finally (Chance _, _, _)
  | Globally ((Exists | Chance _), _, _) | Until _ -> []

let aims checks =
  List.concat_map
    (fun (c : Property.check) ->
       List.map (fun a -> (c.name, a)) (aim (Formula.negation_normal_form c.formula)))
    checks
