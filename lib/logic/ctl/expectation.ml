open Scc_data
open Scc_exact
open Scc_chance
open Decisions

type what =
  | Time_until of Timed_formula.t
  | Counts_until of (int -> int -> int * int) * Timed_formula.t
  | Value_at of (int -> Rat.t -> (Rat.t, string) result) * Rat.t

type answer =
  | Known of Eval.measured
  | Unknown of { reason : string option; unexplored : int list }

let solve side effort built =
  let solution = Reward.solve (until built) (direction side) effort ~asked:(States built.asked) in
  match built.asked with
  | [ start ] -> Solution.value solution start
  | _ -> Scc_base.Bug.fail __POS__ "an expectation from one place"

(* {1 What is earned until something holds} *)

let width = Rat.make Z.one (Z.shift_left Z.one 40)

(* What a branch earns, at least and at most. *)
type earned = { low : Rat.t; high : Rat.t }

let exactly x = { low = x; high = x }

(* The time that it takes; where it ends at no rational instant, less than that, and more. *)
let duration graph (p : place) branch =
  match branch.way with
  | Move move -> exactly (Timed_graph.duration graph p.node move)
  | During { offset; _ } -> (
      match Algebraic.to_rat offset with
      | Some d -> exactly d
      | None ->
        let low, high = Algebraic.enclose offset ~width in
        { low; high })
  | Nowhere -> exactly Rat.zero

let counted count (p : place) branch =
  match branch.way with
  | Move (Edge k) ->
    let least, most = count p.node k in
    { low = Rat.of_int least; high = Rat.of_int most }
  | Move (Flow _) | During _ | Nowhere -> exactly Rat.zero

let all_time = { Timed_formula.low = Rat.zero; high = None }

(* More states at which it is over make it less, for each scheduler: with all that may be such a state it is not
   more than it is, and with those that are known to be, not less. *)
let mean_until e side ~bound ~earns g =
  let effort = { (Eval.effort e) with bound } in
  let graph = Eval.graph e in
  let value = Eval.value e g in
  let still = Eval.value e (Eval.still e g) in
  let enclosed = ref false in
  let process ~up =
    let f = if up then still.lower else still.upper and g = if up then value.lower else value.upper in
    let q = { graph; side; bound = all_time; f; g; generous = not up } in
    let w = window q in
    let earning p branch =
      let { low; high } = earns p branch in
      if not (Rat.equal low high) then enclosed := true;
      { branch with reward = (if up then high else low) }
    in
    let choices p = List.map (List.map (earning p)) (choices q w p) in
    build ~choices [ next q w (place w 0 Rat.zero) ]
  in
  let low = process ~up:false in
  let least = solve side effort low in
  let all_known = value.lower == value.upper && Timed_graph.complete (Eval.index e) && not !enclosed in
  (* What is not known may be nothing that matters. *)
  let most =
    if all_known then least
    else
      let high = process ~up:true in
      if same_process low high then least else solve side effort high
  in
  Known { least; most }

(* {1 A number at a time} *)

type ends = { mutable reason : string option; mutable unexplored : int list; mutable lowest : Rat.t option }

(* Each branch that time takes past the instant ends there, with what the number is, and more by the shift. *)
let ending ends number time ~shift (p : place) elapsed =
  match number p.node (Rat.sub time elapsed) with
  | Error reason ->
    if ends.reason = None then ends.reason <- Some reason;
    one Nowhere Fail
  | Ok x ->
    ends.lowest <- Some (match ends.lowest with None -> x | Some y -> Rat.min x y);
    one ~reward:(match shift with None -> Rat.zero | Some s -> Rat.sub x s) Nowhere Goal

let over_before ~elapsed time =
  let elapsed = Rat.to_string elapsed and time = Rat.to_string time in
  Printf.sprintf "a run is over at time %s, and has no value at time %s" elapsed time

let steps graph ends number time ~shift (p : place) =
  let elapsed = Option.get p.elapsed in
  let go node d = Go { node; elapsed = Some (Rat.add elapsed d) } in
  let s = p.node in
  let ending () = [ ending ends number time ~shift p elapsed ] in
  if not (graph.Timed_graph.known s) then begin
    ends.unexplored <- s :: ends.unexplored;
    [ one Nowhere Fail ]
  end
  else
    let branch (k, t, probability) =
      { way = Move (Edge k); next = go t Rat.zero; probability; reward = Rat.zero }
    in
    let discrete = List.map (List.map branch) (Timed_graph.edge_choices graph s) in
    let timed =
      match graph.flow s with
      | No_flow when discrete = [] && Rat.equal elapsed time -> ending ()
      | No_flow -> []
      | Forever -> ending ()
      | Lasts (d, targets) ->
        if Rat.compare (Rat.add elapsed d) time > 0 then ending ()
        else List.mapi (fun k t -> one (Move (Flow k)) (go t d)) (Array.to_list targets)
    in
    match discrete @ timed with
    | [] ->
      if ends.reason = None then
        ends.reason <- Some (over_before ~elapsed time);
      [ one Nowhere Fail ]
    | choices -> choices

let endless time =
  Printf.sprintf "runs that go on for ever within one instant do not come to time %s" (Rat.to_string time)

let unknown ends reason = Unknown { reason; unexplored = List.sort_uniq Int.compare ends.unexplored }
let known answer = Known { least = answer; most = answer }

(* Where runs may come back to a node in no time, there are equations. *)
let by_equations e side number time start =
  let graph = Eval.graph e in
  let ends = { reason = None; unexplored = []; lowest = None } in
  let build shift = build ~choices:(steps graph ends number time ~shift) [ start ] in
  (* What is earned is never negative: at first it is only looked what the least is. *)
  let first = build None in
  match (ends.reason, ends.unexplored, ends.lowest) with
  | None, [], Some lowest ->
    let certain = Qualitative.one_min (until first) in
    if not (List.for_all (Bits.mem certain) first.asked) then unknown ends (Some (endless time))
    else known (Answer.add (solve side (Eval.effort e) (build (Some lowest))) lowest)
  | None, [], None -> unknown ends (Some (endless time))
  | reason, _, _ -> unknown ends reason

(* Each run ends, since it never comes back to a node in no time. *)
let value_at e side number time =
  let most = Effort.most_layers (Eval.effort e) in
  let ends = { reason = None; unexplored = []; lowest = None } in
  let start = Go { node = 0; elapsed = Some Rat.zero } in
  let choices = steps (Eval.graph e) ends number time ~shift:(Some Rat.zero) in
  match Layers.means ~most (Eval.graph e) side ~choices time [ start ] with
  | exception Layers.Too_many over -> unknown ends (Some (Layers.too_many ~most ~over time))
  | None -> by_equations e side number time start
  | Some _ when Option.is_some ends.reason || ends.unexplored <> [] -> unknown ends ends.reason
  | Some layers -> known (Layered.value (Layered.solve layers (Eval.effort e)) start)

let find ?bound e side = function
  | Time_until g -> mean_until e side ~bound ~earns:(duration (Eval.graph e)) g
  | Counts_until (count, g) -> mean_until e side ~bound ~earns:(counted count) g
  | Value_at (number, time) -> value_at e side number time

(* {1 As a process} *)

type process = { choices : place -> branch list list; built : built; added : Rat.t }

exception Not_exact

let process_until e side ~earns g =
  let value = Eval.value e g and still = Eval.value e (Eval.still e g) in
  let question generous f g =
    let q = { graph = Eval.graph e; side; bound = all_time; f; g; generous } in
    let w = window q in
    let earning p branch =
      let { low; high } = earns p branch in
      if Rat.equal low high then { branch with reward = low } else raise Not_exact
    in
    let choices p = List.map (List.map (earning p)) (choices q w p) in
    (choices, build ~choices [ next q w (place w 0 Rat.zero) ])
  in
  (* As for bounds: more states at which it is over make it less. *)
  match (question true still.upper value.upper, question false still.lower value.lower) with
  | (choices, built), (_, otherwise) ->
    if same_process built otherwise then Ok { choices; built; added = Rat.zero }
    else Error "not all of what it depends on is known"
  | exception Not_exact -> Error "a time on the way is no rational number"

(* All of what it may come to is looked at once, to see what the least number is. *)
let process_at e number time =
  let graph = Eval.graph e in
  let ends = { reason = None; unexplored = []; lowest = None } in
  let start = Go { node = 0; elapsed = Some Rat.zero } in
  let first = build ~choices:(steps graph ends number time ~shift:None) [ start ] in
  match (ends.reason, ends.unexplored, ends.lowest) with
  | Some reason, _, _ -> Error reason
  | None, _ :: _, _ -> Error "not all of what it depends on is known"
  | None, [], None -> Error (endless time)
  | None, [], Some lowest ->
    let certain = Qualitative.one_min (until first) in
    if not (List.for_all (Bits.mem certain) first.asked) then Error (endless time)
    else
      let choices = steps graph ends number time ~shift:(Some lowest) in
      Ok { choices; built = build ~choices [ start ]; added = lowest }

let process e side = function
  | Time_until g -> process_until e side ~earns:(duration (Eval.graph e)) g
  | Counts_until (count, g) -> process_until e side ~earns:(counted count) g
  | Value_at (number, time) -> process_at e number time
