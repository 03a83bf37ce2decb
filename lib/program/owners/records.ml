open Scc_graph_search
open Scc_state_space
open Scc_codec
module Wire = Scc_parallel.Wire.Make (Network_exchange)

type direction = {
  wire : Wire.t;
  last : int array;  (** the state before *)
  mutable before : int;
  mutable instant : int;  (** the last one that is not 0 *)
  numbers : (int, int) Hashtbl.t;  (** of times, as they are sent, by those of the clock, or the other way round *)
}

type t = {
  clock : Clock.t option;
  sends : direction;
  text : Buffer.t;
  reads : direction;
  near : Tuples.spread;
  mutable last_id : int;  (** of the state that was read before; -1 for none *)
}

let direction context =
  {
    wire = Wire.make context; last = Array.make (Network_lts.width context) (-1);
    before = 0; instant = 0;
    numbers = Hashtbl.create 16;
  }

let make part =
  let context = Scc_successors.Filter.context (Part.filter part) in
  {
    clock = Part.clock part;
    sends = direction context; text = Buffer.create 4096;
    reads = direction context; near = Tuples.spread (Part.table part);
    last_id = -1;
  }

(* Small numbers of either sign are small. *)
let signed n = if n >= 0 then 2 * n else (-2 * n) - 1
let unsigned n = if n land 1 = 0 then n / 2 else -((n + 1) / 2)

let put_number buffer d n =
  Packed.put_nat buffer (signed (n - d.before));
  d.before <- n

let read_number source d =
  d.before <- d.before + unsigned (Packed.nat source);
  d.before

let remember d (changes : Tuples.changes) =
  for i = 0 to (Array.length changes / 2) - 1 do
    d.last.(changes.(2 * i)) <- changes.((2 * i) + 1)
  done

let put_state buffer d tuple =
  let changes = Tuples.difference d.last tuple in
  Wire.put_changes d.wire buffer changes;
  remember d changes

(* A time is sent once, and then by a number. *)
let put_time buffer d clock time =
  match Hashtbl.find_opt d.numbers time with
  | Some n -> Packed.put_nat buffer n
  | None ->
    let n = Hashtbl.length d.numbers in
    Hashtbl.add d.numbers time n;
    Packed.put_nat buffer n;
    Packed.put_rational buffer (Clock.time clock time)

let read_time source d clock =
  let count = Hashtbl.length d.numbers in
  let n = Packed.below (count + 1) ~what:"the number of a time" source in
  if n < count then Hashtbl.find d.numbers n
  else begin
    let time = Clock.number clock (Packed.rational source) in
    Hashtbl.add d.numbers n time;
    time
  end

(* Most states that are reached without time are so by as many transitions as the one before. *)
let put_choice buffer d ~instant choice =
  if instant = 0 || instant = d.instant then Packed.put_nat buffer ((3 * choice) + Int.min 1 instant)
  else begin
    Packed.put_nat buffer ((3 * choice) + 2);
    Packed.put_nat buffer instant;
    d.instant <- instant
  end

let read_choice source d =
  let n = Packed.nat source in
  if n mod 3 = 2 then d.instant <- Packed.nat source;
  ((if n mod 3 = 0 then 0 else d.instant), n / 3)

let put r ~time ~instant ~before ~choice tuple =
  put_number r.text r.sends before;
  put_choice r.text r.sends ~instant choice;
  Option.iter (fun clock -> put_time r.text r.sends clock time) r.clock;
  put_state r.text r.sends tuple

let size r = Buffer.length r.text

let take r =
  let text = Buffer.contents r.text in
  Buffer.clear r.text;
  text

type arrow = { id : int; before : int; choice : int }

let read_one r part ~sender source =
  let before = read_number source r.reads in
  let instant, choice = read_choice source r.reads in
  let time = Option.fold ~none:0 ~some:(read_time source r.reads) r.clock in
  let changes = Wire.read_changes r.reads.wire source in
  if before < 0 then raise (Packed.Malformed "there is a number below 0");
  remember r.reads changes;
  if Array.length changes = 0 && r.last_id < 0 then raise (Packed.Malformed "there is no state");
  (* A state that comes twice, one time after the other, differs in nothing. *)
  let last = r.reads.last in
  let changes = if Array.length changes = 0 then [| 0; last.(0) |] else changes in
  let id = Part.enter part ~near:r.near changes last ~time ~instant ~sender ~before ~choice in
  Tuples.load (Part.table part) r.near id;
  r.last_id <- id;
  { id; before; choice }

let read r part ~sender text each =
  let source = Packed.source text in
  try
    while not (Packed.at_end source) do each (read_one r part ~sender source) done
  with
  | Packed.Malformed what | Failure what | Invalid_argument what ->
    Failure.refused "owner %d sends what are no states: %s" (sender + 1) what
