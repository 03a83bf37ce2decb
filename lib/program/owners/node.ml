open Scc_exact
open Scc_ctl
open Scc_codec

type step = { duration : Rat.t; chance : Rat.t option }
type follows = Unknown | Rests | Steps of step array

type t = {
  number : int;
  follows : follows;
  truths : Truth.t array;
  along : (int * Truth.t Timeline.t) list;
  counts : (int * int) array list;
}

let takes_time s = Rat.sign s.duration > 0

let extent follows : Timeline.extent =
  match follows with
  | Unknown -> Instant
  | Rests -> Forever
  | Steps steps -> (
      match List.find_opt takes_time (Array.to_list steps) with Some s -> Lasts s.duration | None -> Instant)

let at_once steps = List.filter (fun s -> not (takes_time s)) (Array.to_list steps)

(* {1 As bytes} *)

module Step = struct
  type t = step

  let equal a b = Rat.equal a.duration b.duration && Option.equal Rat.equal a.chance b.chance
  let hash s = Rat.hash s.duration + Option.fold ~none:0 ~some:(fun p -> 31 * Rat.hash p) s.chance
end

module Kinds = Scc_data.Numbering.Make (Step)

type direction = { kinds : Kinds.t; mutable before : int  (** the number of the last node *) }

let direction () = { kinds = Kinds.create (); before = 0 }
let signed n = if n >= 0 then 2 * n else (-2 * n) - 1
let unsigned n = if n land 1 = 0 then n / 2 else -((n + 1) / 2)

let put_text b text =
  Packed.put_nat b (String.length text);
  Buffer.add_string b text

let put_step d b step =
  let known = Kinds.size d.kinds in
  let kind = Kinds.number d.kinds step in
  Packed.put_nat b kind;
  if kind = known then begin
    Packed.put_rational b step.duration;
    Progress.put_option b Packed.put_rational step.chance
  end

let read_step d s =
  let known = Kinds.size d.kinds in
  let kind = Packed.below (known + 1) ~what:"the kind of a transition" s in
  if kind < known then Kinds.get d.kinds kind
  else begin
    let duration = Packed.rational s in
    let step = { duration; chance = Progress.read_option s Packed.rational } in
    if Rat.sign duration < 0 || Kinds.number d.kinds step <> known then
      raise (Packed.Malformed "a kind of transition comes twice, or takes less than no time");
    step
  end

let put_truth b : Truth.t -> unit = function
  | False -> Packed.put_nat b 0
  | True -> Packed.put_nat b 1
  | Undecided why ->
    Packed.put_nat b 2;
    put_text b why

let read_truth s : Truth.t =
  match Packed.below 3 ~what:"a truth value" s with 0 -> False | 1 -> True | _ -> Undecided (Packed.text s)

let put_timeline b (t : Truth.t Timeline.t) =
  let put_piece b (p : Truth.t Timeline.piece) =
    Moments.put b { offset = p.cut; attained = true };
    put_truth b p.at;
    put_truth b p.after
  in
  put_truth b t.start;
  put_truth b t.first;
  Packed.put_list b put_piece t.rest

let read_timeline extent s =
  let read_piece s : Truth.t Timeline.piece =
    let cut = (Moments.read s).offset in
    let at = read_truth s in
    { cut; at; after = read_truth s }
  in
  let start = read_truth s in
  let first = read_truth s in
  match Timeline.of_pieces extent ~start ~first (Packed.list s read_piece) with
  | Some t -> t
  | None -> raise (Packed.Malformed "a predicate changes at no such times")

let put_follows d b = function
  | Unknown -> Packed.put_nat b 0
  | Rests -> Packed.put_nat b 1
  | Steps steps ->
    Packed.put_nat b (2 + Array.length steps);
    Array.iter (put_step d b) steps

let most_steps = 1 lsl 29

let read_follows d s =
  match Packed.below most_steps ~what:"the number of transitions" s with
  | 0 -> Unknown
  | 1 -> Rests
  | n ->
    (* As many as there are bytes for, at most. *)
    let rec read n steps = if n = 0 then List.rev steps else read (n - 1) (read_step d s :: steps) in
    Steps (Array.of_list (read (n - 2) []))

let put_counts b =
  Array.iter (fun (least, most) ->
      Packed.put_nat b least;
      Packed.put_nat b most)

let put d b node =
  Packed.put_nat b (signed (node.number - d.before));
  d.before <- node.number;
  put_follows d b node.follows;
  Array.iter (put_truth b) node.truths;
  let put_along b (predicate, timeline) =
    Packed.put_nat b predicate;
    put_timeline b timeline
  in
  Packed.put_list b put_along node.along;
  List.iter (put_counts b) node.counts

(* In order: each has bytes of its own. *)
let times n read =
  let rec go k found = if k = n then List.rev found else go (k + 1) (read () :: found) in
  go 0 []

let read d ~size ~predicates ~patterns s =
  let number = d.before + unsigned (Packed.nat s) in
  if number < 0 || number >= size then raise (Packed.Malformed "there is no such node");
  d.before <- number;
  let follows = read_follows d s in
  let truths = Array.of_list (times predicates (fun () -> read_truth s)) in
  let extent = extent follows in
  let read_along s =
    let predicate = Packed.below predicates ~what:"the predicate" s in
    (predicate, read_timeline extent s)
  in
  let along = Packed.list s read_along in
  let edges = match follows with Steps steps -> List.length (at_once steps) | Unknown | Rests -> 0 in
  let read_count () =
    let least = Packed.nat s in
    (least, Packed.nat s)
  in
  let counts = times patterns (fun () -> Array.of_list (times edges read_count)) in
  { number; follows; truths; along; counts }

let put_extent b : Timeline.extent -> unit = function
  | Instant -> Packed.put_nat b 0
  | Forever -> Packed.put_nat b 1
  | Lasts d ->
    Packed.put_nat b 2;
    Packed.put_rational b d

let read_extent s : Timeline.extent =
  match Packed.below 3 ~what:"an extent" s with 0 -> Instant | 1 -> Forever | _ -> Lasts (Packed.rational s)
