open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics

type place = {
  path : int array;
  state : State.t;
  time : Rat.t;
  last : (State.t * Transition.label) option;
}

type entry = { place : place; mutable next : Transition.t list option }

(* By length and hash of the path; the path itself is compared. *)
type t = {
  semantics : Semantics.t;
  initial : State.t;
  most : int;
  table : entry Int_pairs.t;
  order : (int * int) Queue.t;  (** the oldest first *)
}

(* So many leaves in all states that are kept, roughly. *)
let leaves_kept = 100_000

let make semantics ~initial =
  let leaves = 1 + Array.length (Semantics.model semantics).leaves in
  let most = Int.max 2 (Int.min 256 (leaves_kept / leaves)) in
  { semantics; initial; most; table = Int_pairs.create 64; order = Queue.create () }

let semantics t = t.semantics
let model t = Semantics.model t.semantics

(* {1 What is kept} *)

let mix h choice = ((h * 1_000_003) + choice + 1) land max_int

(* The hashes of all beginnings of a path. *)
let hashes path =
  let h = Array.make (Array.length path + 1) 0 in
  Array.iteri (fun i c -> h.(i + 1) <- mix h.(i) c) path;
  h

let begins path (e : entry) =
  let known = e.place.path in
  let rec same i = i = Array.length known || (known.(i) = path.(i) && same (i + 1)) in
  same 0

let start t = { path = [||]; state = t.initial; time = Rat.zero; last = None }

(* The longest beginning of the path that is kept. *)
let nearest t path h =
  let rec look n =
    if n = 0 then { place = start t; next = None }
    else
      match Int_pairs.find_opt t.table (n, h.(n)) with
      | Some e when begins path e -> e
      | Some _ | None -> look (n - 1)
  in
  look (Array.length path)

let entry t path =
  let h = hashes path in
  match Int_pairs.find_opt t.table (Array.length path, h.(Array.length path)) with
  | Some e when begins path e -> Some e
  | Some _ | None -> None

let keep t e =
  let path = e.place.path in
  let key = (Array.length path, (hashes path).(Array.length path)) in
  if not (Int_pairs.mem t.table key) then begin
    if Int_pairs.length t.table >= t.most then Int_pairs.remove t.table (Queue.pop t.order);
    Int_pairs.add t.table key e;
    Queue.push key t.order
  end

(* {1 Following} *)

let transitions t e =
  match e.next with
  | Some next -> next
  | None -> (
      match Network.successors t.semantics e.place.state with
      | Ok next ->
        e.next <- Some next;
        next
      | Error f ->
        let diagnostics = Fault.diagnostics ~source:(fun _ -> None) [ Transition.diagnostic (model t) f ] in
        Fault.refuse (No_transitions { at = Array.length e.place.path; diagnostics }))

let labels model next = List.map (fun (t : Transition.t) -> Transition.label_to_string model t.label) next

let after t e path n =
  let next = transitions t e in
  match List.nth_opt next path.(n) with
  | Some taken ->
    let time = Rat.add e.place.time (Transition.duration taken) in
    let last = Some (e.place.state, taken.label) in
    { place = { path = Array.sub path 0 (n + 1); state = taken.target; time; last }; next = None }
  | None ->
    let possible = labels (model t) next in
    let message = Printf.sprintf "after %d choices, choice %d is not possible" n path.(n) in
    Fault.refuse (Not_possible { at = n; possible; message })

let follow t path =
  let rec go e n = if n = Array.length path then e else go (after t e path n) (n + 1) in
  let e = nearest t path (hashes path) in
  let e = go e (Array.length e.place.path) in
  keep t e;
  e.place

let along t path f =
  let h = hashes path in
  let known n =
    match Int_pairs.find_opt t.table (n, h.(n)) with
    | Some e when begins path e -> Some e
    | Some _ | None -> None
  in
  let rec go e n told =
    if n = Array.length path then List.rev (f e.place None :: told)
    else
      let after = match known (n + 1) with Some e -> e | None -> after t e path n in
      keep t after;
      go after (n + 1) (f e.place (Option.map snd after.place.last) :: told)
  in
  go { place = start t; next = None } 0 []

let next t place =
  match entry t place.path with
  | Some e -> transitions t e
  | None -> transitions t { place; next = None }
