open Scc_exact
open Scc_calculus
open Scc_semantics

type outcome = { tuple : int array; chance : Rat.t; transitions : int }

module Tuple_table = Hashtbl.Make (struct
    type t = int array

    let equal (a : t) (b : t) =
      let rec from i = i < 0 || (Int.equal a.(i) b.(i) && from (i - 1)) in
      Array.length a = Array.length b && from (Array.length a - 1)

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

let most = 1 lsl 16

let through leave outcomes =
  let after o next =
    { next with chance = Rat.mul o.chance next.chance; transitions = o.transitions + next.transitions }
  in
  (* What ends there, and what goes on by a draw, with its number: both the last first. [Error None] where there
     are too many. *)
  let split found o =
    let* ended, count, later = found in
    match leave o.tuple with
    | Error fault -> Error (Some fault)
    | Ok None -> Ok (o :: ended, count, later)
    | Ok (Some next) ->
      let count = count + List.length next in
      if count > most then Error None
      else Ok (ended, count, List.rev_append (List.map (after o) next) later)
  in
  let rec round ended = function
    | [] -> Ok (merged (List.rev ended))
    | outcomes -> (
        match List.fold_left split (Ok (ended, 0, [])) outcomes with
        | Error _ as over -> over
        | Ok (ended, _, later) -> round ended (merged (List.rev later)))
  in
  match round [] (merged outcomes) with
  | Ok outcomes -> Ok (Some outcomes)
  | Error None -> Ok None
  | Error (Some fault) -> Error fault

(* {1 Velocities} *)

(* What a process draws: its slot after all draws, and its number there with the chance of each. *)
type drawn = { slot : int; numbers : (int * Rat.t) list }

let product base drawn =
  let with_one partial { slot; numbers } =
    let drawn o (number, chance) =
      let tuple = Array.copy o.tuple in
      tuple.(slot) <- number;
      { tuple; chance = Rat.mul o.chance chance; transitions = o.transitions + 1 }
    in
    List.concat_map (fun o -> List.map (drawn o) numbers) partial
  in
  List.fold_left with_one [ { tuple = base; chance = Rat.one; transitions = 0 } ] drawn

let drawing c s =
  let chances p = Result.map (fun outcomes -> (p, outcomes)) (Steer.chances c s p) in
  Result.all chances (Steer.drawers c s)

let count drawing =
  List.fold_left (fun n (_, outcomes) -> if n > most then n else n * List.length outcomes) 1 drawing

(* The tuple after all draws, of each the first but for one process. *)
let after_all c catalogue s drawing p velocity =
  let first q = List.find_opt (fun (r, _) -> r == q) drawing in
  let before q = Option.map (fun (q, outcomes) -> if q == p then velocity else fst (List.hd outcomes)) (first q) in
  let last, outcomes = List.nth drawing (List.length drawing - 1) in
  let drawn = if last == p then (velocity, snd (List.hd outcomes)) else List.hd outcomes in
  Result.map
    (fun (t : Transition.t) -> Catalogue.encode catalogue t.target)
    (Network.drawn c s ~before last drawn)

let velocities c catalogue tuple =
  let s = Catalogue.decode catalogue tuple in
  let* drawing = drawing c s in
  if count drawing > most then Ok None
  else
    let after_all = after_all c catalogue s drawing in
    let numbers (p, outcomes) =
      let slot = Catalogue.first_leaf p in
      let number (velocity, chance) = Result.map (fun t -> (t.(slot), chance)) (after_all p velocity) in
      Result.map (fun numbers -> { slot; numbers }) (Result.all number outcomes)
    in
    let* drawn = Result.all numbers drawing in
    let p, outcomes = List.hd drawing in
    let* base = after_all p (fst (List.hd outcomes)) in
    Ok (Some (product base drawn))

(* Each leaf draws by itself when it has let go, and half of the processes with bonds may wait for lots. *)
let joins semantics (initial : State.t) =
  let m = Semantics.model semantics in
  let moves leaf = not m.leaves.(leaf).Model.fixed in
  let of_process (p : State.process) =
    let n = match Steer.chances semantics initial p with Ok chances -> List.length chances | Error _ -> 1 in
    let leaves = List.filter moves (List.map (fun (l : State.leaf) -> l.leaf) (Array.to_list p.leaves)) in
    List.map (fun _ -> max 2 n) leaves
  in
  let more count n = if count > most then count else count * n in
  List.fold_left more 1 (List.concat_map of_process (Array.to_list initial.processes)) <= most
