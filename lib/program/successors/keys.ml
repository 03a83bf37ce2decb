open Scc_exact
open Scc_calculus
open Scc_state_space
open Scc_codec

type fingerprint = int array

let words = 4
let modulus = 0xFFFF_FFFF

(* A piece of a state: the bytes of a process of the network, or those of all the rest. *)
type piece = { bytes : string; print : fingerprint }

type t = {
  context : Network_lts.context;
  catalogue : Catalogue.t;
  codec : State_codec.t;
  leaves : int;
  has_events : bool;
  mutable pieces : piece array;  (** of the processes, by number; {!unknown} of those not met yet *)
  recent : int array;  (** the processes that were read last, by a hash of how their bytes begin *)
  rests : (string, State.step option * Rat.t option * int list) Hashtbl.t;
  mutable rest : int array * piece;  (** the last state whose rest was asked for, and that *)
  seen : int array;  (** by leaf: the round in which it was last met *)
  mutable round : int;
}

let word_in text k = Int32.to_int (String.get_int32_le text (4 * k)) land modulus

let piece bytes =
  let digest = Digest.string bytes in
  { bytes; print = Array.init words (word_in digest) }

let unknown = { bytes = ""; print = [||] }
let recent_size = 1 lsl 14

let make context initial =
  let catalogue = Network_lts.catalogue context in
  let model = Network_lts.model context in
  {
    context; catalogue;
    codec = State_codec.make model initial;
    leaves = Array.length model.leaves;
    has_events = Network_lts.events context <> [];
    pieces = Array.make 1024 unknown;
    recent = Array.make recent_size Catalogue.nobody;
    rests = Hashtbl.create 64;
    rest = ([||], unknown);
    seen = Array.make (Array.length model.leaves) 0;
    round = 0;
  }

(* {1 Pieces} *)

let keep t number p =
  if number >= Array.length t.pieces then begin
    let longer = Array.make (2 * (number + 1)) unknown in
    Array.blit t.pieces 0 longer 0 (Array.length t.pieces);
    t.pieces <- longer
  end;
  t.pieces.(number) <- p

let written put =
  let buffer = Buffer.create 64 in
  put buffer;
  piece (Buffer.contents buffer)

let process t number =
  let known = if number < Array.length t.pieces then Array.unsafe_get t.pieces number else unknown in
  if known != unknown then known
  else begin
    let p = written (fun b -> State_codec.put_process t.codec b (Catalogue.body t.catalogue number).process) in
    keep t number p;
    p
  end

let put_events t buffer tuple =
  if t.has_events then begin
    let places = Network_lts.happened t.context tuple in
    Packed.put_nat buffer (List.length places);
    List.iter (Packed.put_nat buffer) places
  end

(* Hardly ever is it another one than that of the state before. *)
let rest t tuple =
  let known, p = t.rest in
  if known != [||] && Catalogue.same_rest t.catalogue known tuple then p
  else begin
    let put b =
      State_codec.put_rest b ~step:(Catalogue.step t.catalogue tuple) ~time:(Catalogue.time t.catalogue tuple);
      put_events t b tuple
    in
    let p = written put in
    t.rest <- (Array.copy tuple, p);
    p
  end

(* {1 Writing} *)

let count t tuple =
  let rec from i n =
    if i = t.leaves then n else from (i + 1) (if tuple.(i) = Catalogue.nobody then n else n + 1)
  in
  from 0 0

let put t buffer tuple =
  State_codec.put_head buffer (count t tuple);
  for i = 0 to t.leaves - 1 do
    let p = tuple.(i) in
    if p <> Catalogue.nobody then Buffer.add_string buffer (process t p).bytes
  done;
  Buffer.add_string buffer (rest t tuple).bytes

let bytes t tuple =
  let buffer = Buffer.create 256 in
  put t buffer tuple;
  Buffer.contents buffer

(* {1 Reading} *)

let malformed what = raise (Packed.Malformed what)

let stands_at text from piece =
  let n = String.length piece in
  let rec same_bytes i = i >= n || (Char.equal piece.[i] text.[from + i] && same_bytes (i + 1)) in
  let rec same i =
    if i + 8 > n then same_bytes i
    else Int64.equal (String.get_int64_le piece i) (String.get_int64_le text (from + i)) && same (i + 8)
  in
  from + n <= String.length text && same 0

(* Most processes are shorter than what is looked at, three parts of 8 bytes, and few of them begin alike and are
   not the same. Near the end of a state there are fewer parts. *)
let hash text from =
  let part k =
    let at = from + (8 * k) in
    if at + 8 > String.length text then 0 else Int64.to_int (String.get_int64_le text at)
  in
  let mixed = ((part 0 * 0x1E3779B97F4A7C15) lxor part 1) * 0x1E3779B97F4A7C15 in
  (((mixed lxor (mixed lsr 31) lxor part 2) * 0x1E3779B97F4A7C15) lsr 40) land (recent_size - 1)

let read_new t text from =
  let p, next = State_codec.read_process t.codec text ~from in
  let number = Catalogue.process t.catalogue p in
  keep t number (piece (String.sub text from (next - from)));
  (number, next)

(* The process that begins at a place of the text, and where it ends. *)
let read_process t text from =
  let k = hash text from in
  let known = t.recent.(k) in
  if known <> Catalogue.nobody && stands_at text from (process t known).bytes then
    (known, from + String.length (process t known).bytes)
  else begin
    let number, next = read_new t text from in
    t.recent.(k) <- number;
    (number, next)
  end

let enter t tuple last number =
  let p = (Catalogue.body t.catalogue number).process in
  let first = Catalogue.first_leaf p in
  if first <= last then malformed "processes are not in order";
  let meet (l : State.leaf) =
    if t.seen.(l.leaf) = t.round then malformed "a body is there twice";
    t.seen.(l.leaf) <- t.round
  in
  Array.iter meet p.leaves;
  tuple.(first) <- number;
  first

(* The places are in order, each one once. *)
let read_events t source =
  if not t.has_events then []
  else
    let most = List.length (Network_lts.events t.context) in
    let places = Packed.list source (Packed.below most ~what:"the event") in
    if List.sort_uniq Int.compare places = places then places else malformed "events are not in order"

let read_rest t text from =
  let bytes = String.sub text from (String.length text - from) in
  match Hashtbl.find_opt t.rests bytes with
  | Some known -> known
  | None ->
    let source = Packed.source bytes in
    let step, time = State_codec.read_rest source in
    let places = read_events t source in
    if not (Packed.at_end source) then malformed "there is more than a state";
    let model = Network_lts.model t.context in
    if Option.is_some step <> Model.of_all model || Option.is_some time <> model.keeps_time then
      malformed "it has a movement step or a time where states have none, or none where they have";
    if Hashtbl.length t.rests > recent_size then Hashtbl.reset t.rests;
    Hashtbl.replace t.rests bytes (step, time, places);
    (step, time, places)

let read_whole t text =
  let source = Packed.source text in
  let count = State_codec.read_head source in
  let tuple = Array.make (Catalogue.width t.catalogue) Catalogue.nobody in
  t.round <- t.round + 1;
  let rec processes left last from =
    if left = 0 then from
    else
      let number, next = read_process t text from in
      processes (left - 1) (enter t tuple last number) next
  in
  if count > t.leaves then malformed "there are more processes than bodies";
  let step, time, places = read_rest t text (processes count (-1) (Packed.place source)) in
  Catalogue.put_rest t.catalogue tuple ~step ~time;
  if t.has_events then Network_lts.set_happened t.context tuple places;
  tuple

let read t text ~from ~stop =
  match read_whole t (String.sub text from (stop - from)) with
  | tuple -> Ok tuple
  | exception Packed.Malformed what -> Error what

(* {1 Fingerprints} *)

let no_fingerprint () = Array.make words 0

(* All fingerprints have four words. *)
let[@inline] word_of (print : fingerprint) k = Array.unsafe_get print k
let[@inline] put_word (print : fingerprint) k w = Array.unsafe_set print k (w land modulus)

let add into print =
  put_word into 0 (word_of into 0 + word_of print 0);
  put_word into 1 (word_of into 1 + word_of print 1);
  put_word into 2 (word_of into 2 + word_of print 2);
  put_word into 3 (word_of into 3 + word_of print 3)

let take from print =
  put_word from 0 (word_of from 0 - word_of print 0);
  put_word from 1 (word_of from 1 - word_of print 1);
  put_word from 2 (word_of from 2 - word_of print 2);
  put_word from 3 (word_of from 3 - word_of print 3)

let fingerprint t tuple =
  let sum = Array.copy (rest t tuple).print in
  for i = 0 to t.leaves - 1 do
    if tuple.(i) <> Catalogue.nobody then add sum (process t tuple.(i)).print
  done;
  sum

let move t ~into before tuple changes target =
  Array.blit before 0 into 0 words;
  let other = ref false in
  for i = 0 to (Array.length changes / 2) - 1 do
    let slot = changes.(2 * i) in
    if slot >= t.leaves then other := true
    else begin
      let old = tuple.(slot) and now = changes.((2 * i) + 1) in
      if old <> Catalogue.nobody then take into (process t old).print;
      if now <> Catalogue.nobody then add into (process t now).print
    end
  done;
  if !other then begin
    take into (rest t tuple).print;
    add into (rest t target).print
  end

let after t before tuple changes target =
  let print = Array.make words 0 in
  move t ~into:print before tuple changes target;
  print

let put_fingerprint buffer print = Array.iter (fun w -> Buffer.add_int32_le buffer (Int32.of_int w)) print

let hex print =
  let buffer = Buffer.create 16 in
  put_fingerprint buffer print;
  let digit c = Printf.sprintf "%02x" (Char.code c) in
  String.concat "" (List.map digit (List.of_seq (String.to_seq (Buffer.contents buffer))))
