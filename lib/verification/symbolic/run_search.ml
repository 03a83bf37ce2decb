open Scc_exact
open Scc_polyhedra
open Timed_sets
open Scc_state_sets

type finish = There | Rests | Passes of Rat.t | Repeats of int | Goes_on of int
type walk = { way : Concrete.way; node : int; inside : (int * Linear.t) option }

let steps w = w.way.length
let dimension w = Polyhedron.dimension w.way.set
let in_set w set = if Polyhedron.is_empty set then None else Some { w with way = { w.way with set } }

(* The part of a walk for which these forms are in the set. *)
let within w forms union =
  let dimension = dimension w in
  let forms = Array.map (Concrete.extended dimension) forms in
  let in_piece p = in_set w (Polyhedron.inter w.way.set (Polyhedron.preimage p ~dimension forms)) in
  List.filter_map in_piece (Union.pieces union)

let constrained w constraints = Option.to_list (in_set w (Polyhedron.add_all w.way.set constraints))

(* The part of it that is in a set of states. *)
let among (s : sets) w =
  match w.inside with
  | None -> within w w.way.here s.at.(w.node)
  | Some (k, d) -> within w (Array.append w.way.here [| d |]) (List.nth s.along.(w.node) k)

let follow w (e : Zone_graph.edge) =
  let way = Concrete.along w.way e in
  if Polyhedron.is_empty way.set then None else Some { way; node = e.target; inside = None }

(* {1 Moves}

   What a run does that keeps to states of [before], until it has left the node. *)

type rule = { m : model; before : sets; otherwise : sets  (** the complement *) }

let rule m before = { m; before; otherwise = complement m before }
let node rule w = rule.m.nodes.(w.node)

let stretches rule w =
  let bad = rule.otherwise.along.(w.node) and good = rule.before.along.(w.node) in
  let all = List.mapi (fun k s -> (k, s, List.nth bad k, List.nth good k)) (node rule w).stretches in
  match w.inside with None -> all | Some (k, _) -> List.filter (fun (i, _, _, _) -> i = k) all

(* To the end of a stretch. *)
let to_end w s bad =
  match w.inside with
  | None -> within w w.way.here (clear_from_start s ~bad)
  | Some (_, d) -> within w (Array.append w.way.here [| d |]) (clear_to_end s bad)

(* Later in a stretch, by a time that the last variable is, to a state of the set. *)
let later w s bad target =
  let last = Linear.variable (dimension w) (dimension w - 1) in
  match w.inside with
  | None -> within w (Array.append w.way.here [| last |]) (not_after s ~bad target)
  | Some (_, d) ->
    let clear w = within w (Array.append w.way.here [| d; last |]) (clear_until s bad) in
    List.concat_map clear (within w (Array.append w.way.here [| last |]) target)

let splits rule w =
  let of_split ((to_halted : Zone_graph.edge), edges) =
    let way = Concrete.along w.way to_halted in
    if Polyhedron.is_empty way.set then []
    else
      let n = Polyhedron.dimension way.set in
      (* The variables of the node that time passes from, rather than those of the halted one. *)
      let from = { w with way = { way with here = w.way.here } } in
      let no_time = Constraint.equals (Linear.variable n (n - 1)) (Linear.constant n Rat.zero) in
      let at_once = if w.inside = None then constrained from [ no_time ] else [] in
      let after (_, s, bad, good) = later from s bad good in
      let halted = List.map (fun f -> { f with way = { way with set = f.way.set } }) in
      let all = halted (at_once @ List.concat_map after (stretches rule w)) in
      List.concat_map (fun h -> List.filter_map (follow h) (Option.value edges ~default:[])) all
  in
  List.concat_map of_split (node rule w).splits

let happens rule w = if w.inside = None then List.filter_map (follow w) (node rule w).happens else []

let passes rule w =
  let of_stretch (_, s, bad, _) =
    List.concat_map (fun w -> List.filter_map (follow w) (node rule w).passes) (to_end w s bad)
  in
  List.concat_map of_stretch (stretches rule w)

let moves rule w =
  List.concat_map (fun w -> happens rule w @ passes rule w @ splits rule w) (among rule.before w)

(* {1 Where a run ends} *)

(* In a stretch: to states of the set, with states of [before] on the way there. *)
let onward rule (target : sets) w =
  let of_stretch (k, s, bad, _) =
    let target = List.nth target.along.(w.node) k in
    if Union.is_empty target then []
    else
      let wider = { w with way = Concrete.extend w.way 1 } in
      let n = dimension wider in
      let arrive w = { w with inside = Some (k, Linear.variable n (n - 1)) } in
      List.map arrive (later wider s bad target)
  in
  List.concat_map of_stretch (stretches rule w)

let right_after m states w = onward (rule m states) states w

let comes rule goal w =
  List.map (fun w -> (w, There)) (among goal w @ List.concat_map (onward rule goal) (among rule.before w))

let leads rule goal w =
  List.map (fun w -> (w, There)) (List.concat_map (among goal) (happens rule w @ splits rule w))

let stays rule ~high w =
  let n = node rule w in
  let zone = n.it.zone in
  let over w (e : Zone_graph.edge) =
    match (e.step, zone.time, high) with
    | Passes f, Some time, Some h ->
      let enters = in_set w (fst (Concrete.enter w.way e.guard)).set in
      let late = Linear.sub (Linear.add time f) (Linear.constant (Zone.dimension zone) h) in
      let beyond w =
        let dimension = dimension w in
        let here = Array.map (Concrete.extended dimension) w.way.here in
        let late = Linear.compose late ~dimension here in
        constrained w [ Constraint.greater late (Linear.constant dimension Rat.zero) ]
      in
      List.concat_map beyond (Option.to_list enters)
    | _ -> []
  in
  let of_stretch w (_, (s : stretch), bad, _) =
    let undisturbed = List.concat_map (fun w -> within w w.way.here (some s.region)) (to_end w s bad) in
    let for_ever = if s.for_ever then undisturbed else [] in
    let rests = match high with None -> Rests | Some h -> Passes h in
    let late = List.concat_map (fun w -> within w w.way.here (late n s)) undisturbed in
    let later = List.concat_map (fun w -> List.concat_map (over w) n.passes) undisturbed in
    List.map (fun w -> (w, rests)) for_ever @ List.map (fun w -> (w, rests)) (late @ later)
  in
  List.concat_map (fun w -> List.concat_map (of_stretch w) (stretches rule w)) (among rule.before w)

(* {1 Searches} *)

let most_walks = 3_000
let most_again = 300

(* How often a run that is to come back may go through one node. *)
let most_rounds = 8

module Nodes = Map.Make (Int)

(* How a node was gone through: its variables, and how many steps had been taken. *)
type passed = { here : Linear.t array; steps : int }

(* Of a walk: for each node how it went through it, the last time first. *)
let gone_through trail node = Option.value (Nodes.find_opt node trail) ~default:[]

let gone_on trail (w : walk) =
  Nodes.add w.node ({ here = w.way.here; steps = steps w } :: gone_through trail w.node) trail

(* Where a walk is in the very state again that it was in. *)
let closes (w : walk) passed ~takes_time =
  let n = dimension w in
  let over = Concrete.extended n in
  let same = Array.map2 (fun a b -> Constraint.equals (over a) (over b)) passed.here w.way.here in
  let since = Scc_data.Lists.take (steps w - passed.steps) w.way.taken in
  let add sum (_, time) = match time with Some t -> Linear.add sum (over t) | None -> sum in
  let zero = Linear.constant n Rat.zero in
  let time = Constraint.greater (List.fold_left add zero since) zero in
  List.map (fun w -> (w, Repeats passed.steps))
    (constrained w ((if takes_time then [ time ] else []) @ Array.to_list same))

let first_of list = match list with [] -> None | x :: _ -> Some x

(* Breadth-first, by some moves. Runs that come to where others came before are not followed, unless [again]. *)
let breadth_first rule ~moves ~win ~ends ~round ~again from =
  let seen = Array.map (fun n -> Union.empty (Zone.dimension n.it.zone)) rule.m.nodes in
  let waiting = Queue.create () and left = ref (if again then most_again else most_walks) in
  let at_one_instant = ref None and goes_on = ref None in
  let keep r list = if !r = None then r := first_of list in
  let is_new w =
    let image = Polyhedron.image w.way.set (Array.map (Concrete.extended (dimension w)) w.way.here) in
    again
    || (not (Union.covers seen.(w.node) image))
       && begin
         seen.(w.node) <- Union.union seen.(w.node) (Union.of_polyhedron image);
         true
       end
  in
  let enter trail w =
    let before = if round then gone_through trail w.node else [] in
    match first_of (List.concat_map (closes w ~takes_time:true) before) with
    | Some _ as found -> found
    | None ->
      keep at_one_instant (List.concat_map (closes w ~takes_time:false) before);
      keep goes_on (List.map (fun p -> (w, Goes_on p.steps)) before);
      if List.compare_length_with before most_rounds < 0 && is_new w then Queue.push (w, trail) waiting;
      None
  in
  let rec go () =
    match Queue.take_opt waiting with
    | None -> None
    | Some _ when !left = 0 -> None
    | Some (w, trail) -> (
        decr left;
        match ends w with
        | found :: _ -> Some found
        | [] -> (
            let trail = if round && w.inside = None then gone_on trail w else trail in
            let next = List.concat_map (among win) (moves rule w) in
            match List.find_map (enter trail) next with Some _ as found -> found | None -> go ()))
  in
  Queue.push (from, Nodes.empty) waiting;
  let found = go () in
  (found, !at_one_instant, !goes_on)

let some_run m search ~win ~high from =
  match (search : Branching.search) with
  | Comes { before; goal } ->
    let rule = rule m before in
    let ends = comes rule goal in
    let found, _, _ = breadth_first rule ~moves ~win ~ends ~round:false ~again:false from in
    found
  | Leads goal ->
    let rule = rule m (everything m ~may:false) in
    let ends = leads rule goal in
    let found, _, _ = breadth_first rule ~moves:passes ~win ~ends ~round:false ~again:false from in
    found
  | Stays { states; over = _ } -> (
      let rule = rule m states in
      let look again = breadth_first rule ~moves ~win ~ends:(stays rule ~high) ~round:true ~again from in
      let first, at_one_instant, goes_on = look false in
      match (first, at_one_instant) with
      | (Some _ as found), _ | None, (Some _ as found) -> found
      | None, None -> (
          let found, at_one_instant, _ = look true in
          match (found, at_one_instant) with
          | (Some _ as found), _ | None, (Some _ as found) -> found
          | None, None -> goes_on))
