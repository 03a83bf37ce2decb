open Scc_calculus

(** Which of their parts is asked about, and the answer. *)
type ('parts, 'answer) pair = { other : State.process; which : 'parts; answer : 'answer }

type together = (Transition.outcome list, Transition.fault) result

type known = {
  process : State.process;
  mutable parts : Part.t list option;
  mutable urgent : Transition.outcome list option;
  mutable weak : Transition.outcome list option;
  mutable contacts : ((int * int) * (int * int), Kinematics.contact) pair list;
  mutable together : (unit, together) pair list;
}

(* Some processes for each slot, which is the first leaf: the one that was asked about last comes first. *)
type t = { remembers : bool; mutable slots : known option array array }

let none = { remembers = false; slots = [||] }
let create () = { remembers = true; slots = [||] }
let renewed t = if t.remembers then create () else none

(* States that are looked at one after another have much in common, and each leads to others, in which something is
   made anew. *)
let ways = 6

let make_room t slot =
  let slots = Array.make (Int.max (slot + 1) (2 * Array.length t.slots)) [||] in
  Array.blit t.slots 0 slots 0 (Array.length t.slots);
  t.slots <- slots

let put_first here i known =
  Array.blit here 0 here 1 i;
  here.(0) <- Some known;
  known

let unknown process = { process; parts = None; urgent = None; weak = None; contacts = []; together = [] }

let add t slot process =
  if Array.length t.slots.(slot) = 0 then t.slots.(slot) <- Array.make ways None;
  put_first t.slots.(slot) (ways - 1) (unknown process)

(* The same value in memory: to compare all of it would cost as much as some answers. *)
let find t (process : State.process) =
  if not t.remembers then unknown process
  else begin
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
  end

let at index parts =
  match parts with
  | (first : Part.t) :: _ when first.process <> index ->
    List.map (fun (p : Part.t) -> { p with process = index }) parts
  | _ -> parts

let parts t index process look =
  if not t.remembers then look ()
  else
    let k = find t process in
    match k.parts with
    | Some parts -> at index parts
    | None ->
      let parts = look () in
      k.parts <- Some parts;
      parts

let outcomes known keep look =
  match known with
  | Some outcomes -> outcomes
  | None ->
    let outcomes = look () in
    keep (Some outcomes);
    outcomes

let urgent t process look =
  let k = find t process in
  outcomes k.urgent (fun found -> k.urgent <- found) look

let weak t process look =
  let k = find t process in
  outcomes k.weak (fun found -> k.weak <- found) look

(* {1 Two} *)

let most = 32

let rec found same other = function
  | [] -> None
  | p :: _ when p.other == other && same p.which -> Some p.answer
  | _ :: rest -> found same other rest

let kept pairs pair = if List.compare_length_with pairs most < 0 then pair :: pairs else [ pair ]

let contact t (a : Part.t) (b : Part.t) look =
  if not t.remembers then look ()
  else
    let k = find t a.owner in
    let is (leaf, index) (p : Part.t) = p.leaf.leaf = leaf && p.index = index in
    match found (fun (one, two) -> is one a && is two b) b.owner k.contacts with
    | Some answer -> answer
    | None ->
      let answer = look () in
      k.contacts <- kept k.contacts { other = b.owner; which = (Part.name a, Part.name b); answer };
      answer

let together t p q look =
  let k = find t p in
  match found (fun () -> true) q k.together with
  | Some answer -> answer
  | None ->
    let answer = look () in
    k.together <- kept k.together { other = q; which = (); answer };
    answer
