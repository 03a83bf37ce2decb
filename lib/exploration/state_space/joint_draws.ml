open Scc_exact
open Scc_calculus
open Scc_semantics

type outcome = { tuple : int array; chance : Rat.t; transitions : int }

module Tuple_table = Hashtbl.Make (struct
    type t = int array

    let equal (a : int array) b = a = b
    let hash t = Array.fold_left (fun h n -> ((1_000_003 * h) + n) land max_int) 0 t
  end)

let merged outcomes =
  let found = Tuple_table.create 64 in
  let add order o =
    match Tuple_table.find_opt found o.tuple with
    | None ->
      Tuple_table.add found o.tuple o;
      o.tuple :: order
    | Some other ->
      let transitions = Int.min o.transitions other.transitions in
      Tuple_table.replace found o.tuple { o with chance = Rat.add o.chance other.chance; transitions };
      order
  in
  let order = List.fold_left add [] outcomes in
  List.rev_map (Tuple_table.find found) order

let through leave outcomes =
  let after o next =
    { next with chance = Rat.mul o.chance next.chance; transitions = o.transitions + next.transitions }
  in
  let rec round ended = function
    | [] -> Ok (merged (List.rev ended))
    | outcomes ->
      let rec each ended later = function
        | [] -> round ended (merged (List.rev later))
        | o :: rest -> (
            match leave o.tuple with
            | Error _ as fault -> fault
            | Ok None -> each (o :: ended) later rest
            | Ok (Some next) -> each ended (List.rev_append (List.map (after o) next) later) rest)
      in
      each ended [] outcomes
  in
  round [] (merged outcomes)

(* {1 Velocities} *)

(* What a process draws: its slot after all draws, and its number there with the chance of each. *)
type drawn = { slot : int; numbers : (int * Rat.t) list }

let product base drawn =
  let tuple = Array.copy base and found = ref [] and transitions = List.length drawn in
  let rec from chance = function
    | [] -> found := { tuple = Array.copy tuple; chance; transitions } :: !found
    | { slot; numbers } :: rest ->
      List.iter
        (fun (number, c) ->
           tuple.(slot) <- number;
           from (Rat.mul chance c) rest)
        numbers
  in
  from Rat.one drawn;
  List.rev !found

let velocities c catalogue tuple =
  let s = Catalogue.decode catalogue tuple in
  let rec chances found = function
    | [] -> Ok (List.rev found)
    | p :: rest ->
      let* outcomes = Steer.chances c s p in
      chances ((p, outcomes) :: found) rest
  in
  let* drawing = chances [] (Steer.drawers c s) in
  let last, last_outcomes = List.nth drawing (List.length drawing - 1) in
  let first = List.map (fun (p, outcomes) -> (p, fst (List.hd outcomes))) drawing in
  (* The state after the first velocities, but for that of one process. *)
  let after_all p velocity =
    let velocity_of q = if q == p then velocity else List.assq q first in
    let before (q : State.process) = if List.mem_assq q first then Some (velocity_of q) else None in
    let* t = Network.drawn c s ~before last (velocity_of last, snd (List.hd last_outcomes)) in
    Ok (Catalogue.encode catalogue t.Transition.target)
  in
  let* base = after_all last (List.assq last first) in
  let rec numbers slot p found = function
    | [] -> Ok { slot; numbers = List.rev found }
    | (velocity, chance) :: rest ->
      let* tuple = after_all p velocity in
      numbers slot p ((tuple.(slot), chance) :: found) rest
  in
  let rec all found = function
    | [] -> Ok (List.rev found)
    | (p, outcomes) :: rest ->
      let* one = numbers (Catalogue.first_leaf p) p [] outcomes in
      all (one :: found) rest
  in
  let* drawn = all [] drawing in
  Ok (product base drawn)
