open Scc_exact
open Scc_calculus
module Ints = Set.Make (Int)

type outcome = { label : Transition.label; rules : Rule.t list; pieces : State.process list }

(* Takes bonds out of a process, lets leaves continue, and makes a process of each component. *)
let fall_apart (m : Model.t) (p : State.process) ~released continuations =
  let kept =
    Array.to_list p.bonds |> List.filter (fun b -> not (List.exists (State.equal_bond b) released))
  in
  let leaves = Array.map (Process.continue continuations) p.leaves in
  State.components leaves (Array.of_list kept)
  |> List.map (fun (leaves, bonds) ->
      let piece = State.process ~leaves ~bonds ~velocity:p.velocity ~clock:None () in
      Process.restart_clock m (match m.rigid with None -> piece | Some _ -> Turn.piece m ~whole:p piece))

let weak m (p : State.process) =
  let release (b : State.bond) =
    Process.weak_offers m p b
    |> List.map (fun (first, second, rules) ->
        {
          label = Transition.Weak_split b;
          rules = Rule.Weak_split :: rules;
          pieces =
            fall_apart m p ~released:[ b ] [ (b.one.at, first); (b.two.at, second) ];
        })
  in
  match p.clock with
  | Some c when Rat.sign c = 0 -> List.concat_map release (Array.to_list p.bonds)
  | Some _ | None -> []

(* Rule StrongSplit. A reaction is grown from its least bond: whoever is at an end of a bond of X must choose
   a summand rho(L) whose entries match exactly the bonds of X at that leaf, which may bring in more bonds,
   whose other ends must choose in turn. *)

type reaction = {
  bonds : Ints.t;  (** X, indices into the bonds of the process *)
  chosen : (int * Behaviour.t) list;  (** leaves that have chosen, with what they become *)
  used : Rule.t list;
}

let site_at (b : State.bond) leaf = if b.one.at = leaf then b.one.site else b.two.site

(* Whether the entries of L can be matched one to one with the bonds (augmenting paths). *)
let matches (p : State.process) leaf entries bonds =
  let entries = Array.of_list entries and bonds = Array.of_list bonds in
  let fits e b =
    let bond = p.bonds.(bonds.(b)) in
    let entry : Behaviour.channel = entries.(e) in
    String.equal entry.name bond.name && Behaviour.active entry (site_at bond leaf)
  in
  let owner = Array.make (Array.length bonds) (-1) in
  let rec augment seen e =
    let rec attempt b =
      if b >= Array.length bonds then false
      else if (not seen.(b)) && fits e b then begin
        seen.(b) <- true;
        if owner.(b) < 0 || augment seen owner.(b) then begin
          owner.(b) <- e;
          true
        end
        else attempt (b + 1)
      end
      else attempt (b + 1)
    in
    attempt 0
  in
  Array.length entries = Array.length bonds
  && List.for_all
    (fun e -> augment (Array.make (Array.length bonds) false) e)
    (List.init (Array.length entries) Fun.id)

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
  Behaviour.derivations m.definitions l.behaviour
  |> List.concat_map (fun (offer, derivation) ->
      match offer with
      | Behaviour.Offer_strong (entries, b) ->
        subsets (List.length entries - List.length required) optional
        |> List.filter (fun extra -> matches p l.leaf entries (required @ extra))
        |> List.map (fun extra ->
            {
              bonds = Ints.union reaction.bonds (Ints.of_list extra);
              chosen = (l.leaf, b) :: reaction.chosen;
              used = Process.union reaction.used (Process.rules Rule.Strong derivation);
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
  grow { bonds = Ints.singleton least; chosen = []; used = [] }

let offers_strong (m : Model.t) (l : State.leaf) =
  List.exists
    (function
      | Behaviour.Offer_strong _ -> true
      | Offer_open _ | Offer_weak _ -> false)
    (Behaviour.offers m.definitions l.behaviour)

let strong m (p : State.process) =
  if not (Array.exists (offers_strong m) p.leaves) then []
  else
    List.concat_map (reactions m p) (List.init (Array.length p.bonds) Fun.id)
    |> List.map (fun reaction ->
        let released = List.map (fun i -> p.bonds.(i)) (Ints.elements reaction.bonds) in
        {
          label = Transition.Strong_split released;
          rules = Rule.Strong_split :: reaction.used;
          pieces = fall_apart m p ~released reaction.chosen;
        })
