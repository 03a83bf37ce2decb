open Bigarray
open Scc_base
open Scc_shared
open Scc_codec
open Scc_graph_search

(* A slot is memory for a request and its answers: how far it is; the microseconds that the answers took; the
   number of states, and they; for each of them the place of its answer, once it has one; and the answers. *)
type slot = Shared_memory.numbers

(* How far a request is: 0 of none; asked; or so many more than the number of states that have been answered. *)
let asked = 1
let answers = 2
let header = 3

(* In the place of an answer: nobody is at the state; somebody is; it is left to the process that numbers states.
   Places are greater. *)
let free = 0
let taken = 1
let untold = 2

let request (slot : slot) states =
  let count = Array.length states in
  slot.{2} <- count;
  Array.iteri (fun k i -> slot.{header + k} <- i) states;
  for k = 0 to count - 1 do
    slot.{header + count + k} <- free
  done;
  Shared_memory.write slot 0 asked

let answered (slot : slot) = Shared_memory.read slot 0 - answers
let[@inline] where (slot : slot) k = header + slot.{2} + k

(* Who finds it free has it. What has been put there meanwhile is put back: only one process reads it. *)
let take slot k =
  let at = where slot k in
  let before = Shared_memory.swap slot at taken in
  if before >= untold then Shared_memory.write slot at before;
  before = free

type progress = Free | Taken | Untold | Answered of int

let progress slot k =
  let place = Shared_memory.read slot (where slot k) in
  if place > untold then Answered place else if place = free then Free else if place = taken then Taken else Untold

let seconds (slot : slot) = 1e-6 *. float_of_int slot.{1}

type bells = Shared_memory.numbers

(* Whoever waits says so, and looks once more before it sleeps; who has written something looks who waits. *)
let main = 0
let worker = 1
let pause = 2
let bells () = Shared_memory.numbers 3
let say_waiting bells who = ignore (Shared_memory.swap bells who 1)
let is_waiting bells who = Shared_memory.swap bells who 0 = 1

let is_paused bells = Shared_memory.read bells pause = 1
let end_pause bells = Shared_memory.write bells pause 0

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) = struct
  type shared = { graph : Graph.t; common : Common.t; all_edges : bool; dull : int array -> bool }

  (* Where little is left of the slot, or of the tables, the rest is left to others. Each answer is there for
     others as soon as it is found. *)
  let find { graph; common; all_edges; dull } (slot : slot) ~enough ~each =
    let count = slot.{2} in
    let start = Unix.gettimeofday () in
    let rec from k at =
      if k = count || 4 * at > 3 * Array1.dim slot || Graph.is_room_wanted graph common then k
      else if k > 0 && enough start then k
      else if not (take slot k) then from (k + 1) at
      else
        match Graph.put_answer graph ~all_edges ~dull slot at slot.{header + k} with
        | beyond ->
          Shared_memory.write slot (where slot k) at;
          each ();
          from (k + 1) beyond
        | exception Answers.Too_long ->
          Shared_memory.write slot (where slot k) untold;
          each ();
          k + 1
    in
    let found = from 0 (header + (2 * count)) in
    slot.{1} <- int_of_float (1e6 *. Float.max 0. (Unix.gettimeofday () -. start));
    Shared_memory.write slot 0 (answers + found)

  let find_for shared slot ~seconds =
    find shared slot ~enough:(fun start -> Unix.gettimeofday () -. start > seconds) ~each:ignore

  (** {2 Serving} *)

  (* The slots are used by turns. *)
  let serve shared slots bells channel =
    let { graph; common; _ } = shared in
    let is_asked slot = Shared_memory.read slot 0 = asked in
    let message = Buffer.create 8 in
    let tell_memory () =
      Buffer.clear message;
      Packed.put_nat message (Memory.heap_words ());
      Channel.put channel message
    in
    let rec wait_until is_so =
      if not (is_so ()) then begin
        say_waiting bells worker;
        if not (is_so ()) then ignore (Channel.get channel);
        wait_until is_so
      end
    in
    (* In the midst of an answer, which may have taken long. *)
    let wait_for_room () =
      ignore (Shared_memory.swap bells pause 1);
      if is_waiting bells main then tell_memory ();
      wait_until (fun () -> not (is_paused bells));
      Graph.refresh graph common
    in
    Graph.go_on_apart graph common ~full:wait_for_room;
    let rec go k =
      let slot = slots.(k mod Array.length slots) in
      wait_until (fun () -> is_asked slot);
      Graph.refresh graph common;
      let tell () = if is_waiting bells main then tell_memory () in
      find shared slot ~enough:(fun _ -> false) ~each:tell;
      tell ();
      go (k + 1)
    in
    go 0
end
