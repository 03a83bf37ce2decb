open Scc_base
open Scc_exact
open Scc_rigid
open Scc_calculus
module Ints = Set.Make (Int)

module Owners = Map.Make (Int)

(* {1 Pushes} *)

let part (c : Semantics.t) p ({ at; site } : State.finish) =
  let (module K) = c.kinematics in
  List.find (fun (part : Part.t) -> Part.name part = (at, site.part)) (K.parts c.setting 0 p)

let normal_of_push = function [ n ] -> Some n | [] | _ :: _ -> None

(* Where two parts that hold a bond are pushed apart, and in which direction, of length 1 or hardly less: along the
   only normal of their contact, or from the centroid of the one to that of the other. *)
let line_of_push (c : Semantics.t) p (b : State.bond) =
  let (module K) = c.kinematics in
  let one = part c p b.one and two = part c p b.two in
  match K.near c.setting one two with
  | None -> Bug.fail __POS__ "a bond of parts that are apart"
  | Some { normals; corners; _ } ->
    let along =
      match normal_of_push normals with
      | Some n -> Ivec.to_vec n
      | None -> Vec.sub (Placed.centroid two.placed) (Placed.centroid one.placed)
    in
    let sum = List.fold_left Vec.add Vec.zero corners in
    let mean = Vec.scale (Rat.div Rat.one (Rat.of_int (List.length corners))) sum in
    (mean, Vec.scale (Rat.div Rat.one (Rat.root (Vec.norm2 along))) along)

let pushed_apart (c : Semantics.t) (p : State.process) releases pieces =
  let (module K) = c.kinematics in
  let push pieces ({ bond; push } : Transition.release) =
    if Rat.sign push = 0 then pieces
    else
      let at, direction = line_of_push c p bond in
      let of_leaf leaf impulse piece =
        if State.has_leaf piece leaf then K.pushed c.setting ~at (Vec.scale impulse direction) piece else piece
      in
      List.map (fun q -> of_leaf bond.one.at (Rat.neg push) (of_leaf bond.two.at push q)) pieces
  in
  List.fold_left push pieces releases

(* Takes bonds out of a process, lets leaves continue, and makes a process of each component. *)
let fall_apart (c : Semantics.t) (p : State.process) releases continuations =
  let (module K) = c.kinematics in
  let is_kept b = not (List.exists (fun (r : Transition.release) -> State.equal_bond b r.bond) releases) in
  let kept = List.filter is_kept (Array.to_list p.bonds) in
  let leaves = Array.map (Process.continue continuations) p.leaves in
  State.components leaves (Array.of_list kept)
  |> List.map (fun (leaves, bonds) ->
      State.process ~leaves ~bonds ~velocity:p.velocity ~clock:None ()
      |> K.piece c.setting ~whole:p
      |> Process.piece_step c.setting.model ~whole:p
      |> Process.restart_clock c.setting.model
      |> Lots.piece c.setting.model ~whole:p)
  |> pushed_apart c p releases

(* A bond and the summands by which its two ends let go: of each several of which the same comes. *)
type way = { bond : State.bond; one : Process.released list; two : Process.released list }

let continuations { bond; one; two } =
  [ (bond.one.at, (List.hd one).Process.rest); (bond.two.at, (List.hd two).rest) ]

let release { bond; one; two } =
  { Transition.bond; push = Rat.add (List.hd one).Process.push (List.hd two).push }

let summands { one; two; _ } =
  let both (r : Process.released) = List.map (fun (s : Process.released) -> [ r.how; s.how ]) two in
  List.concat_map both one

(* Who takes part in each way to do all: the first of each, the second of each, and so on, so that all come up. *)
let side_by_side all =
  let left = function [ last ] -> [ last ] | list -> List.tl list in
  let rec from found all =
    let found = List.concat_map List.hd all :: found in
    if List.for_all (fun ways -> List.compare_length_with ways 1 = 0) all then List.rev found
    else from found (List.map left all)
  in
  from [] all

(* Of several processes at once. *)
let released c all =
  let pieces (p, ways) = fall_apart c p (List.map release ways) (List.concat_map continuations ways) in
  let ways = List.concat_map snd all in
  let by_bond (r : Transition.release) (s : Transition.release) = State.compare_bond r.bond s.bond in
  {
    Transition.rule = Rule.Weak_split;
    label = Weak_split (List.sort by_bond (List.map release ways));
    fired = side_by_side (List.map summands ways);
    gone = List.map fst all;
    come = List.sort State.compare_first (List.concat_map pieces all);
  }

let weak (c : Semantics.t) (p : State.process) =
  let one_way bond (one, two) = released c [ (p, [ { bond; one = [ one ]; two = [ two ] } ]) ] in
  let release b = List.map (one_way b) (Process.weak_offers c.setting.model p b) in
  if Process.at_split_instant p then List.concat_map release (Array.to_list p.bonds) else []

(* {1 Rule Lot} *)

(* What becomes of the lot of a bond; [None] where it is not pending any more. *)
let decided (p : State.process) (b : State.bond) decision chance become =
  let decide (c, lot) =
    if State.equal_bond b c then Option.map (fun lot -> (c, lot)) (become lot) else Some (c, lot)
  in
  let after (lots : State.lots) = { lots with pending = List.filter_map decide lots.pending } in
  {
    Transition.rule = Rule.Lot;
    label = Lot { bond = b; decision; chance };
    fired = [];
    gone = [ p ];
    come = [ State.with_lots (Option.map after p.lots) p ];
  }

let total (n : _ Chances.t) = function
  | [] -> None
  | (_, q) :: rest -> Some (List.fold_left (fun sum (_, q) -> n.add sum q) q rest)

(* Each of the two ends draws by itself, if it has a chance; where both let go, the bond is to be released. *)
let decisions (n : _ Chances.t) m p b =
  let choices (side : _ Lots.side) =
    match side.drawn with
    | [] -> [ ([], n.one) ]
    | drawn -> List.map (fun (summand, q) -> ([ (side.finish.at, summand) ], q)) drawn
  in
  match Lots.sides n m p b with
  | None -> Bug.fail __POS__ "lots are pending for what has no chance"
  | Some (one, two) -> (
      let is_more q = Rat.compare (n.value q) Rat.one > 0 in
      let too_much (side : _ Lots.side) = Option.fold ~none:false ~some:is_more (total n side.drawn) in
      match List.find_opt too_much [ one; two ] with
      | Some side -> Error (Transition.Bad_chance side.finish)
      | None ->
        let both (s, q) = List.map (fun (t, r) -> (s @ t, n.mul q r)) (choices two) in
        let ways = List.concat_map both (choices one) in
        let let_go (drawn, q) = (Some drawn, q) in
        let rest = Option.fold ~none:n.one ~some:(n.sub n.one) (total n ways) in
        let kept = if Rat.sign (n.value rest) > 0 then [ (None, rest) ] else [] in
        Ok (List.map let_go ways @ kept))

let draw m p b =
  let outcome = function
    | Some drawn, q -> decided p b Let_go q (fun _ -> Some (State.Let_go drawn))
    | None, q -> decided p b Kept q (fun _ -> None)
  in
  Result.map (List.map outcome) (decisions Chances.rationals m p b)

let first p bonds =
  let chance = Rat.div Rat.one (Rat.of_int (List.length bonds)) in
  let become : State.lot -> State.lot option = function
    | Let_go drawn -> Some (Next drawn)
    | (Undecided | Next _) as lot -> Some lot
  in
  List.map (fun b -> decided p b First chance become) bonds

(* The ways to release a bond: what an end that is free chooses is left open. *)
let ways m p ({ bond; drawn } : Lots.to_release) =
  let followed = Lots.followed m p bond drawn in
  List.concat_map (fun one -> List.map (fun two -> { bond; one; two }) (followed bond.two)) (followed bond.one)

let choose m p (r : Lots.to_release) =
  let by { bond; one; two } =
    let summand (offers : Process.released list) = (List.hd offers).how.summand in
    let drawn = [ (bond.one.at, summand one); (bond.two.at, summand two) ] in
    let become : State.lot -> State.lot option = function
      | Let_go _ -> Some (Let_go drawn)
      | Next _ -> Some (Next drawn)
      | Undecided -> Some Undecided
    in
    decided p bond Chosen Rat.one become
  in
  List.map by (ways m p r)

(* One bond at most may be released in several ways: there is an outcome for each. *)
let release_all c all =
  let m = Semantics.model c in
  let with_each found ways =
    List.concat_map (fun others -> List.map (fun way -> way :: others) ways) found
  in
  let every all = List.map List.rev (List.fold_left with_each [ [] ] all) in
  let of_process (p, bonds) = List.map (fun ways -> (p, ways)) (every (List.map (ways m p) bonds)) in
  List.map (released c) (every (List.map of_process all))

let lots (c : Semantics.t) (due : Lots.due) =
  let m = Semantics.model c in
  match due with
  | To_draw (p, b) -> draw m p b
  | To_be_first (p, bonds) -> Ok (first p bonds)
  | To_choose (p, r) -> Ok (choose m p r)
  | To_release all -> Ok (release_all c all)

(* Rule StrongSplit. A reaction is grown from its least bond: whoever is at an end of a bond of X must choose
   a summand rho(L) whose entries match exactly the bonds of X at that leaf, which may bring in more bonds,
   whose other ends must choose in turn. *)

type chosen = { rest : Behaviour.t; push : Rat.t }

type reaction = {
  bonds : Ints.t;  (** X, indices into the bonds of the process *)
  chosen : (int * chosen) list;  (** leaves that have chosen *)
  fired : Behaviours.derivation list;
}

let site_at (b : State.bond) leaf = if b.one.at = leaf then b.one.site else b.two.site

(* Whether the entries of L can be matched one to one with the bonds: entry by entry, each time along a path on
   which bonds change their owners. [seen] are the bonds tried on this path. *)
let matches (p : State.process) leaf entries bonds =
  let entries = Array.of_list entries and bonds = Array.of_list bonds in
  let fits e b =
    let bond = p.bonds.(bonds.(b)) in
    let entry : Behaviour.channel = entries.(e) in
    String.equal entry.name bond.name && Behaviour.active entry (site_at bond leaf)
  in
  let rec augment seen owners e = attempt seen owners e 0
  and attempt seen owners e (b : int) =
    if b >= Array.length bonds then Error seen
    else if Ints.mem b seen || not (fits e b) then attempt seen owners e (b + 1)
    else
      let seen = Ints.add b seen in
      match Owners.find_opt b owners with
      | None -> Ok (Owners.add b e owners)
      | Some other -> (
          match augment seen owners other with
          | Ok owners -> Ok (Owners.add b e owners)
          | Error seen -> attempt seen owners e (b + 1))
  in
  let rec all owners e =
    e = Array.length entries
    || match augment Ints.empty owners e with Ok owners -> all owners (e + 1) | Error _ -> false
  in
  Array.length entries = Array.length bonds && all Owners.empty 0

(* The subsets of [optional] with [count] elements. *)
let rec subsets count optional =
  if count = 0 then [ [] ]
  else if count < 0 || List.length optional < count then []
  else
    match optional with
    | [] -> []
    | x :: rest -> List.map (fun s -> x :: s) (subsets (count - 1) rest) @ subsets count rest

(* The ways in which one leaf can join a reaction: its summands with a set of bonds each. *)
let choices (m : Model.t) (p : State.process) reaction ~least (l : State.leaf) =
  let at_leaf i = p.bonds.(i).one.at = l.leaf || p.bonds.(i).two.at = l.leaf in
  let mine = List.filter at_leaf (List.init (Array.length p.bonds) Fun.id) in
  let required, rest = List.partition (fun i -> Ints.mem i reaction.bonds) mine in
  (* Where bonds close rings, the leaf at the other end of a bond may have chosen, without it. *)
  let other i = if p.bonds.(i).one.at = l.leaf then p.bonds.(i).two.at else p.bonds.(i).one.at in
  let open_yet i = not (List.mem_assoc (other i) reaction.chosen) in
  let optional = List.filter (fun (i : int) -> i > least && open_yet i) rest in
  Behaviours.derivations m.definitions l.behaviour
  |> List.concat_map (fun (offer, derivation) ->
      match offer with
      | Behaviours.Offer_strong (entries, push, rest) ->
        subsets (List.length entries - List.length required) optional
        |> List.filter (fun extra -> matches p l.leaf entries (required @ extra))
        |> List.map (fun extra ->
            {
              bonds = Ints.union reaction.bonds (Ints.of_list extra);
              chosen = (l.leaf, { rest; push }) :: reaction.chosen;
              fired = derivation :: reaction.fired;
            })
      | Offer_open _ | Offer_weak _ -> [])

let next_to_choose (p : State.process) reaction =
  let undecided leaf = not (List.mem_assoc leaf reaction.chosen) in
  Ints.elements reaction.bonds
  |> List.concat_map (fun i -> [ p.bonds.(i).one.at; p.bonds.(i).two.at ])
  |> List.find_opt undecided

let reactions m (p : State.process) least =
  let rec grow reaction =
    match next_to_choose p reaction with
    | None -> [ reaction ]
    | Some at -> List.concat_map grow (choices m p reaction ~least (State.leaf_of p at))
  in
  grow { bonds = Ints.singleton least; chosen = []; fired = [] }

let offers_strong (m : Model.t) (l : State.leaf) =
  List.exists
    (function
      | Behaviours.Offer_strong _ -> true
      | Offer_open _ | Offer_weak _ -> false)
    (Behaviours.offers m.definitions l.behaviour)

let strong (c : Semantics.t) (p : State.process) =
  let m = c.setting.model in
  if Array.length p.bonds = 0 || not (Array.exists (offers_strong m) p.leaves) then []
  else
    List.concat_map (reactions m p) (List.init (Array.length p.bonds) Fun.id)
    |> List.map (fun reaction ->
        let push leaf = (List.assoc leaf reaction.chosen).push in
        let release i =
          let bond = p.bonds.(i) in
          { Transition.bond; push = Rat.add (push bond.one.at) (push bond.two.at) }
        in
        let releases = List.map release (Ints.elements reaction.bonds) in
        let continuations = List.map (fun (leaf, { rest; _ }) -> (leaf, rest)) reaction.chosen in
        {
          Transition.rule = Rule.Strong_split;
          label = Strong_split releases;
          fired = [ reaction.fired ];
          gone = [ p ];
          come = fall_apart c p releases continuations;
        })
