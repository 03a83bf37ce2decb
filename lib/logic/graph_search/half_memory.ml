type entry = {
  mutable half : int;
  mutable changes : int array array;
  mutable after : int array;
  mutable count : int;  (** of the changes that are remembered *)
}

type t = {
  mutable seen : int array;  (** the half that was asked about last, by its place *)
  mutable entries : entry array;
  mutable kept : int;  (** since there have been so many *)
  mutable now : entry;
  mutable next : int;  (** of its changes *)
}

let first_size = 1 lsl 6
let most = 1 lsl 13
let most_changes = 32

(* Of halves that have come up but once, and of those that have not. *)
let none = { half = -1; changes = [||]; after = [||]; count = 0 }

let create () =
  { seen = Array.make first_size (-1); entries = Array.make first_size none; kept = 0; now = none; next = 0 }

let[@inline] place t half = half land (Array.length t.seen - 1)

(* Made to the end before they take the place of the old ones: work may be given up anywhere. *)
let enlarge t =
  let size = 2 * Array.length t.seen in
  let seen = Array.make size (-1) and entries = Array.make size none in
  let put i e =
    let half = t.seen.(i) in
    if half >= 0 then seen.(half land (size - 1)) <- half;
    if e != none then entries.(e.half land (size - 1)) <- e
  in
  Array.iteri put t.entries;
  t.seen <- seen;
  t.entries <- entries;
  t.kept <- 0

let begin_entry t half =
  if t.kept >= Array.length t.seen && Array.length t.seen < most then enlarge t;
  t.kept <- t.kept + 1;
  let i = place t half in
  if t.entries.(i) == none then t.entries.(i) <- { none with half };
  let e = t.entries.(i) in
  e.count <- 0;
  e.half <- half;
  e

let start t half =
  let i = place t half in
  let e = Array.unsafe_get t.entries i in
  t.next <- 0;
  t.now <-
    (if e.half = half then e
     else if Array.unsafe_get t.seen i = half then begin_entry t half
     else begin
       Array.unsafe_set t.seen i half;
       none
     end)

let find t changes =
  let e = t.now and i = t.next in
  if i < e.count && Array.unsafe_get e.changes i == changes then begin
    t.next <- i + 1;
    Array.unsafe_get e.after i
  end
  else -1

let make_room e =
  let length = Int.max 4 (2 * Array.length e.after) in
  let longer a any = Array.append a (Array.make (length - Array.length a) any) in
  let changes = longer e.changes [||] in
  e.after <- longer e.after 0;
  e.changes <- changes

(* Nothing is allocated between the writes, so that they are made all or none. *)
let keep t changes after =
  let e = t.now and i = t.next in
  if e != none && i < most_changes then begin
    if i >= Array.length e.changes then make_room e;
    e.changes.(i) <- changes;
    e.after.(i) <- after;
    if i >= e.count then e.count <- i + 1;
    t.next <- i + 1
  end
