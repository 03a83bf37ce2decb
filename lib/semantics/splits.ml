open Scc_calculus
module Ints = Set.Make (Int)

module Owners = Map.Make (Int)

(* Takes bonds out of a process, lets leaves continue, and makes a process of each component. *)
let fall_apart (c : Semantics.t) (p : State.process) ~released continuations =
  let (module K) = c.kinematics in
  let kept =
    Array.to_list p.bonds |> List.filter (fun b -> not (List.exists (State.equal_bond b) released))
  in
  let leaves = Array.map (Process.continue continuations) p.leaves in
  State.components leaves (Array.of_list kept)
  |> List.map (fun (leaves, bonds) ->
      State.process ~leaves ~bonds ~velocity:p.velocity ~clock:None ()
      |> K.piece c.setting ~whole:p
      |> Process.piece_step c.setting.model ~whole:p
      |> Process.restart_clock c.setting.model)

let weak (c : Semantics.t) (p : State.process) =
  let release (b : State.bond) =
    Process.weak_offers c.setting.model p b
    |> List.map (fun ((first, one), (second, two)) ->
        {
          Transition.rule = Rule.Weak_split;
          label = Weak_split b;
          fired = [ [ one; two ] ];
          gone = [ p ];
          come = fall_apart c p ~released:[ b ] [ (b.one.at, first); (b.two.at, second) ];
        })
  in
  if Process.at_split_instant p then List.concat_map release (Array.to_list p.bonds) else []

(* Rule StrongSplit. A reaction is grown from its least bond: whoever is at an end of a bond of X must choose
   a summand rho(L) whose entries match exactly the bonds of X at that leaf, which may bring in more bonds,
   whose other ends must choose in turn. *)

type reaction = {
  bonds : Ints.t;  (** X, indices into the bonds of the process *)
  chosen : (int * Behaviour.t) list;  (** leaves that have chosen, with what they become *)
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
  and attempt seen owners e b =
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
  (* As bonds form a tree, a bond that is not of X yet leads to a leaf that has not chosen yet. *)
  let optional = List.filter (fun i -> i > least) rest in
  Behaviours.derivations m.definitions l.behaviour
  |> List.concat_map (fun (offer, derivation) ->
      match offer with
      | Behaviours.Offer_strong (entries, b) ->
        subsets (List.length entries - List.length required) optional
        |> List.filter (fun extra -> matches p l.leaf entries (required @ extra))
        |> List.map (fun extra ->
            {
              bonds = Ints.union reaction.bonds (Ints.of_list extra);
              chosen = (l.leaf, b) :: reaction.chosen;
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
  if not (Array.exists (offers_strong m) p.leaves) then []
  else
    List.concat_map (reactions m p) (List.init (Array.length p.bonds) Fun.id)
    |> List.map (fun reaction ->
        let released = List.map (fun i -> p.bonds.(i)) (Ints.elements reaction.bonds) in
        {
          Transition.rule = Rule.Strong_split;
          label = Strong_split released;
          fired = [ reaction.fired ];
          gone = [ p ];
          come = fall_apart c p ~released reaction.chosen;
        })
