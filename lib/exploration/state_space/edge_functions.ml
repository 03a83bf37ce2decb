open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics

exception Ambiguous
exception Refused of Diag.t

(* What chance decides next in a state: the values of the probabilities, with their functions. *)
let outcomes range c (s : State.t) =
  let n = Chances.open_numbers range in
  if Lots.pending s then
    match Lots.due (Semantics.model c) s with
    | Some (To_draw (p, b)) -> Result.map (List.map snd) (Splits.decisions n (Semantics.model c) p b)
    | Some (To_be_first _ | To_choose _ | To_release _) | None -> Ok []
  else
    match Steer.next_to_draw c s with
    | Some p -> Result.map (List.map snd) (Steer.chances_in n c s p)
    | None -> Ok []

let code : Transition.fault -> Code.t = function
  | Bad_law _ -> Code.bad_law
  | Bad_chance _ -> Code.bad_chance
  | Persistent_contact _ -> Scc_base.Bug.fail __POS__ "a contact is no probability"

let refuse code (range : Ranges.range) what =
  let hint = Open_number.narrower range in
  raise (Refused (Diag.error code Span.none ~hint "%s" what))

module Functions = Hashtbl.Make (Rational_function)

let check range checked (value, f) =
  if Rat.sign value <= 0 then refuse Code.bad_law range "a probability is not positive";
  if Option.is_none (Rational_function.to_constant f) && not (Functions.mem checked f) then begin
    (match Open_number.vanishing range f with
     | None -> ()
     | Some x ->
       refuse Code.bad_law range
         (Printf.sprintf
            "a probability, %s, is 0 or not defined for %s: transitions would come and go there"
            (Rational_function.to_string ~variable:range.name f)
            (Open_number.at range x)));
    Functions.add checked f ()
  end

(* Functions by their values, which tell them apart. *)
let lookup outcomes q =
  match List.filter (fun (value, _) -> Rat.equal value q) outcomes with
  | [] -> Rational_function.constant q
  | (_, f) :: rest -> if List.for_all (fun (_, g) -> Rational_function.equal f g) rest then f else raise Ambiguous

let make context (range : Ranges.range) ~tuple (graph : Scc_ctl.Timed_graph.t) : Scc_ctl.Sensitivity.parameter =
  let c = Network_lts.semantics context and catalogue = Network_lts.catalogue context in
  let checked = Functions.create 16 in
  let of_node s chances =
    match outcomes range c (Catalogue.decode catalogue (tuple s)) with
    | Ok outcomes ->
      List.iter (check range checked) outcomes;
      let known q =
        if outcomes <> [] && not (List.exists (fun (value, _) -> Rat.equal value q) outcomes) then
          Bug.fail __POS__ "an edge whose probability is not among those that are drawn";
        lookup outcomes q
      in
      Array.map (Option.map known) chances
    | Error fault ->
      let text = (Transition.diagnostic (Semantics.model c) ~at:[||] fault).message in
      refuse (code fault) range (Printf.sprintf "for some value of `%s`: %s" range.name text)
  in
  let functions s = if graph.known s then Option.map (of_node s) (graph.drawn s) else None in
  let all = Array.init graph.size functions in
  { low = range.low.value; high = range.high.value; drawn = Array.get all }
