open Scc_calculus
open Scc_semantics

(** The answer about a pair: its second process, which parts of the two were asked about, and what was answered. *)
type ('parts, 'answer) pair = { other : State.process; which : 'parts; answer : 'answer }

type entry = {
  process : State.process;
  mutable parts : Part.t list option;
  mutable urgent : Transition.outcome list option;
  mutable weak : Transition.outcome list option;
  mutable contacts : ((int * int) * (int * int), Kinematics.contact) pair list;
  mutable collisions : (unit, Memo.collision) pair list;
}

(* Some entries for each slot, which is the number of the first leaf of a process: the one used last comes first.
*)
type t = { mutable slots : entry option array array }

(* Explorations visit states that have most processes in common, and each state leads to several others. *)
let ways = 6

let make_room t slot =
  let slots = Array.make (Int.max (slot + 1) (2 * Array.length t.slots)) [||] in
  Array.blit t.slots 0 slots 0 (Array.length t.slots);
  t.slots <- slots

let put_first here i entry =
  Array.blit here 0 here 1 i;
  here.(0) <- Some entry;
  entry

let empty process = { process; parts = None; urgent = None; weak = None; contacts = []; collisions = [] }

let add t slot process =
  if Array.length t.slots.(slot) = 0 then t.slots.(slot) <- Array.make ways None;
  put_first t.slots.(slot) (ways - 1) (empty process)

(* By address: comparing all of a process would cost as much as some of the answers. *)
let find t (process : State.process) =
  let slot = process.leaves.(0).leaf in
  if slot >= Array.length t.slots then make_room t slot;
  let here = t.slots.(slot) in
  let rec from i =
    if i >= Array.length here then add t slot process
    else
      match here.(i) with
      | Some k when k.process == process -> if i = 0 then k else put_first here i k
      | Some _ | None -> from (i + 1)
  in
  from 0

(* {1 One process} *)

let kept known keep work_out =
  match known with
  | Some answer -> answer
  | None ->
    let answer = work_out () in
    keep (Some answer);
    answer

(* The same parts for a process whose place in the network has changed. *)
let at index = function
  | (first : Part.t) :: _ as parts when first.process <> index ->
    List.map (fun (p : Part.t) -> { p with process = index }) parts
  | parts -> parts

let parts t index process work_out =
  let k = find t process in
  at index (kept k.parts (fun found -> k.parts <- found) work_out)

let urgent t process work_out =
  let k = find t process in
  kept k.urgent (fun found -> k.urgent <- found) work_out

let weak t process work_out =
  let k = find t process in
  kept k.weak (fun found -> k.weak <- found) work_out

(* {1 Two processes} *)

let most = 32

let rec found same other = function
  | [] -> None
  | p :: _ when p.other == other && same p.which -> Some p.answer
  | _ :: rest -> found same other rest

let with_room pairs pair = if List.compare_length_with pairs most < 0 then pair :: pairs else [ pair ]

let contact t (a : Part.t) (b : Part.t) work_out =
  let k = find t a.owner in
  let is (leaf, index) (p : Part.t) = p.leaf.leaf = leaf && p.index = index in
  match found (fun (one, two) -> is one a && is two b) b.owner k.contacts with
  | Some answer -> answer
  | None ->
    let answer = work_out () in
    k.contacts <- with_room k.contacts { other = b.owner; which = (Part.name a, Part.name b); answer };
    answer

let collision t p q work_out =
  let k = find t p in
  match found (fun () -> true) q k.collisions with
  | Some answer -> answer
  | None ->
    let answer = work_out () in
    k.collisions <- with_room k.collisions { other = q; which = (); answer };
    answer

let rec create () : Memo.t =
  let t = { slots = [||] } in
  {
    parts = (fun index p work_out -> parts t index p work_out);
    urgent = (fun p work_out -> urgent t p work_out);
    weak = (fun p work_out -> weak t p work_out);
    contact = (fun a b work_out -> contact t a b work_out);
    collision = (fun p q work_out -> collision t p q work_out);
    renewed = create;
  }
