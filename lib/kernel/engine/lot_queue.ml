open Scc_calculus
open Scc_semantics
module Firsts = Map.Make (Int)

(* Processes by their first leaves, in the order of decisions. *)
type stage =
  | Draws of (int * State.bond list) list  (** the bonds of each that are still to be drawn for *)
  | Contests of int list  (** those in which bonds are to be first *)
  | Choices of { queue : int list; several : int }
  (** those that have bonds with several ways, and how many such bonds there are in all *)

type t = {
  model : Model.t;
  order : int list;
  mutable waiting : State.process Firsts.t;  (** those at which lots are pending, as they are now *)
  mutable stage : stage;
}

let first (p : State.process) = p.leaves.(0).leaf
let find t leaf = Firsts.find leaf t.waiting
let ways t p = List.length (Lots.several_ways t.model p)

let rec go_on t =
  let those test = List.filter (fun leaf -> Option.fold ~none:false ~some:test (Firsts.find_opt leaf t.waiting)) in
  match t.stage with
  | Draws [] ->
    t.stage <- Contests (those Lots.some_contested t.order);
    go_on t
  | Contests [] ->
    let queue = those (fun p -> ways t p > 0) t.order in
    let several = List.fold_left (fun sum leaf -> sum + ways t (find t leaf)) 0 queue in
    t.stage <- Choices { queue; several }
  | Draws (_ :: _) | Contests (_ :: _) | Choices _ -> ()

let make model processes =
  let in_order = Process.by_velocity model processes in
  let add all p = Firsts.add (first p) p all in
  let undecided p = match Lots.undecided model p with [] -> None | bonds -> Some (first p, bonds) in
  let t =
    {
      model;
      order = List.map first in_order;
      waiting = List.fold_left add Firsts.empty processes;
      stage = Draws (List.filter_map undecided in_order);
    }
  in
  go_on t;
  t

let is_over t = Firsts.is_empty t.waiting

let due t : Lots.due =
  match t.stage with
  | Draws ((leaf, bond :: _) :: _) -> To_draw (find t leaf, bond)
  | Contests (leaf :: _) ->
    let p = find t leaf in
    To_be_first (p, Lots.contested t.model p)
  | Choices { queue = leaf :: _; several } when several > 1 ->
    let p = find t leaf in
    To_choose (p, List.hd (Lots.several_ways t.model p))
  | Choices _ -> To_release (List.map (fun (_, p) -> (p, Lots.released_now t.model p)) (Firsts.bindings t.waiting))
  | Draws _ | Contests [] -> Scc_base.Bug.fail __POS__ "a stage without work"

let draws t =
  match t.stage with Draws (_ :: _) | Contests (_ :: _) -> true | Draws [] | Contests [] | Choices _ -> false

let decide t p =
  let before = find t (first p) in
  t.waiting <- (if Lots.is_pending p then Firsts.add (first p) p else Firsts.remove (first p)) t.waiting;
  (match t.stage with
   | Draws ((leaf, _ :: (_ :: _ as bonds)) :: rest) -> t.stage <- Draws ((leaf, bonds) :: rest)
   | Draws (_ :: rest) -> t.stage <- Draws rest
   | Contests (_ :: rest) -> if not (Lots.some_contested p) then t.stage <- Contests rest
   | Choices { queue; several } ->
     let left = ways t p in
     let queue = if left = 0 then List.tl queue else queue in
     t.stage <- Choices { queue; several = several - ways t before + left }
   | Draws [] | Contests [] -> Scc_base.Bug.fail __POS__ "a stage without work");
  go_on t
