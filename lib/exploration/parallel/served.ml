open Bigarray
open Scc_base
open Scc_shared
open Scc_codec
open Scc_graph_search

(* A slot is memory for a request and its answers: how far it is; the microseconds that the answers took; the number
   of states, and they; for each of them the place of its answer; and the answers. *)
type slot = Shared_memory.numbers

(* How far a request is: 0 of none; asked; or so many more than the number of states that have been answered. *)
let asked = 1
let answers = 2
let header = 3

let request (slot : slot) states =
  slot.{2} <- Array.length states;
  Array.iteri (fun k i -> slot.{header + k} <- i) states;
  Shared_memory.write slot 0 asked

let answered (slot : slot) = Shared_memory.read slot 0 - answers
let place (slot : slot) k = slot.{header + slot.{2} + k}
let seconds (slot : slot) = 1e-6 *. float_of_int slot.{1}

type bells = Shared_memory.numbers

(* Whoever waits says so, and looks once more before it sleeps; who has written something looks who waits. *)
let main = 0
let worker = 1
let bells () = Shared_memory.numbers 2
let say_waiting bells who = ignore (Shared_memory.swap bells who 1)
let is_waiting bells who = Shared_memory.swap bells who 0 = 1

exception No_room

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) = struct
  type shared = { graph : Graph.t; common : Common.t; all_edges : bool; dull : int array -> bool }

  (* Where little is left of the slot, or of the tables, the rest is left to others. *)
  let find { graph; common; all_edges; dull } (slot : slot) =
    let count = slot.{2} in
    let rec from k at =
      if k = count || 4 * at > 3 * Array1.dim slot || Graph.is_room_wanted graph common then k
      else
        match Graph.put_answer graph ~all_edges ~dull slot at slot.{header + k} with
        | beyond ->
          slot.{header + count + k} <- at;
          from (k + 1) beyond
        | exception (No_room | Ahead.Too_long) -> k
    in
    let start = Unix.gettimeofday () in
    let found = from 0 (header + (2 * count)) in
    slot.{1} <- int_of_float (1e6 *. Float.max 0. (Unix.gettimeofday () -. start));
    Shared_memory.write slot 0 (answers + found)

  (** {2 Serving} *)

  (* The slots are used by turns. *)
  let serve shared slots bells channel =
    let { graph; common; _ } = shared in
    Graph.go_on_apart graph common ~full:(fun () -> raise No_room);
    let is_asked slot = Shared_memory.read slot 0 = asked in
    let message = Buffer.create 8 in
    let tell_memory () =
      Buffer.clear message;
      Packed.put_nat message (Memory.heap_words ());
      Channel.put channel message
    in
    let rec wait slot =
      if not (is_asked slot) then begin
        say_waiting bells worker;
        if not (is_asked slot) then ignore (Channel.get channel);
        wait slot
      end
    in
    let rec go k =
      let slot = slots.(k mod Array.length slots) in
      wait slot;
      Graph.refresh graph common;
      find shared slot;
      if is_waiting bells main then tell_memory ();
      go (k + 1)
    in
    go 0
end
