(* Small graphs as transition systems, whose things have other numbers in each process. *)

open Scc_exact
open Scc_graph_search

(* For each state its transitions (target, duration), or a fault. *)
type toy = (int * int) list option array

(* Things are numbered as they come up, so that no two processes have the same numbers for them. *)
module Numbers = struct
  type t = { number : (int, int) Hashtbl.t; mutable things : int list; first : int; common : Common.numbers }

  let create first = { number = Hashtbl.create 8; things = []; first; common = Common.numbers () }
  let beyond t = t.first + List.length t.things

  let own t thing =
    match Hashtbl.find_opt t.number thing with
    | Some n -> n
    | None ->
      let n = beyond t in
      t.things <- t.things @ [ thing ];
      Hashtbl.replace t.number thing n;
      n

  let thing t own = List.nth t.things (own - t.first)
  let intern t thing_ = Common.common t.common (own t thing_) (fun own -> string_of_int (thing t own))
  let get t n = thing t (Common.own t.common n (fun text -> own t (int_of_string text)))
end

(* A state is a number twice, in two slots of one family, so that a change may be of one or two. *)
module Toy = struct
  type context = {
    graph : toy;
    states : Numbers.t;
    durations : Numbers.t;
    reducing : bool;  (** one transition will do where its target is new *)
    dies : int -> bool;  (** in another process, at this state *)
    own : int;  (** the number of this process *)
  }

  type fault = string

  let make ?(reducing = false) ?(dies = fun _ -> false) ?(first = 0) graph =
    {
      graph; reducing; dies;
      states = Numbers.create first;
      durations = Numbers.create first;
      own = Unix.getpid ();
    }

  let width _ = 2

  let encode c s =
    let a = Numbers.intern c.states (s / 3) in
    [| a; Numbers.intern c.states (1000 + (s mod 3)) |]

  let decode c (t : int array) = (3 * Numbers.get c.states t.(0)) + (Numbers.get c.states t.(1) - 1000)
  let initial c = encode c 0

  let step c from (target, d) =
    { Lts.label = Numbers.intern c.durations d; changes = Tuples.difference from (encode c target) }

  let successors c tuple =
    let s = decode c tuple in
    if c.dies s && Unix.getpid () <> c.own then Unix._exit 9;
    match c.graph.(s) with
    | Some l -> Ok (List.map (step c tuple) l)
    | None -> Error "broken"

  let reduced c tuple =
    match c.graph.(decode c tuple) with
    | Some (first :: _ :: _) when c.reducing -> Some [ step c tuple first ]
    | Some _ | None -> None

  let entered _ _ = ()
  let numbers_so_far c = Int.max (Numbers.beyond c.states) (Numbers.beyond c.durations)

  let share c table =
    Common.share c.states.common table ~kind:0 ~base:(Numbers.beyond c.states);
    Common.share c.durations.common table ~kind:1 ~base:(Numbers.beyond c.durations);
    true

  let has_entered _ _ = true
  let transitions _ _ = 1
  let duration c label = Rat.of_int (Numbers.get c.durations label)
  let longest _ = 0
  let bits _ _ = 0
end

module Exchange = struct
  type context = Toy.context

  let width = Toy.width
  let families _ = 1
  let family _ _ = 0
  let component (c : context) ~family:_ n = string_of_int (Numbers.get c.states n)
  let of_component (c : context) ~family:_ text = Numbers.intern c.states (int_of_string text)
  let name (c : context) n = string_of_int (Numbers.get c.durations n)
  let of_name (c : context) text = Numbers.intern c.durations (int_of_string text)
end
