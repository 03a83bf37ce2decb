open Scc_data

type t = {
  mutable draft : int array;
  mutable drafted : int;
  mutable pool : int array;  (* the members of all sets, one set after the other *)
  mutable pooled : int;
  ends : Int_array.buffer;  (* where each set ends in the pool *)
  mutable slots : int array;  (* open addressing: the set's number plus one, 0 when empty *)
  places : Int_array.buffer;  (* the slot of each set *)
}

let create () =
  {
    draft = Array.make 64 0;
    drafted = 0;
    pool = Array.make 256 0;
    pooled = 0;
    ends = Int_array.buffer ();
    slots = Array.make 64 0;
    places = Int_array.buffer ();
  }

let count t = Int_array.size t.ends

let clear t =
  for i = 0 to Int_array.size t.places - 1 do
    t.slots.(Int_array.nth t.places i) <- 0
  done;
  Int_array.clear t.places;
  Int_array.clear t.ends;
  t.pooled <- 0

let widened a need =
  let b = Array.make (max need (2 * Array.length a)) 0 in
  Array.blit a 0 b 0 (Array.length a);
  b

let start t = t.drafted <- 0

let add t x =
  if t.drafted = Array.length t.draft then t.draft <- widened t.draft 0;
  t.draft.(t.drafted) <- x;
  t.drafted <- t.drafted + 1

let begin_of t set = if set = 0 then 0 else Int_array.nth t.ends (set - 1)

(* Up to this many, insertion is faster than merging. *)
let few = 24

let insertion_sort a n =
  for i = 1 to n - 1 do
    let x : int = a.(i) in
    let j = ref (i - 1) in
    while !j >= 0 && a.(!j) > x do
      a.(!j + 1) <- a.(!j);
      decr j
    done;
    a.(!j + 1) <- x
  done

let sort t =
  if t.drafted <= few then insertion_sort t.draft t.drafted
  else begin
    let part = Array.sub t.draft 0 t.drafted in
    Array.stable_sort Int.compare part;
    Array.blit part 0 t.draft 0 t.drafted
  end

let drop_repetitions t =
  let kept = ref 0 in
  for i = 0 to t.drafted - 1 do
    if !kept = 0 || t.draft.(!kept - 1) <> t.draft.(i) then begin
      t.draft.(!kept) <- t.draft.(i);
      incr kept
    end
  done;
  t.drafted <- !kept

let is_member t set x =
  let rec search lo hi =
    lo < hi
    &&
    let mid = (lo + hi) / 2 in
    t.pool.(mid) = x || if t.pool.(mid) < x then search (mid + 1) hi else search lo mid
  in
  search (begin_of t set) (Int_array.nth t.ends set)

let within t ~except set =
  let rec all i = i = t.drafted || ((t.draft.(i) = except || is_member t set t.draft.(i)) && all (i + 1)) in
  all 0

let hash from a n =
  let h = ref n in
  for i = from to from + n - 1 do
    h := (!h * 0x2545F4914F6CDD1) + a.(i);
    h := !h lxor (!h lsr 29)
  done;
  !h land max_int

let equals_draft t set =
  let from = begin_of t set in
  Int_array.nth t.ends set - from = t.drafted
  &&
  let rec same i = i = t.drafted || (t.pool.(from + i) = t.draft.(i) && same (i + 1)) in
  same 0

let rec free_slot slots i = if slots.(i) = 0 then i else free_slot slots ((i + 1) land (Array.length slots - 1))

let widen_slots t =
  let slots = Array.make (2 * Array.length t.slots) 0 in
  for set = 0 to count t - 1 do
    let from = begin_of t set in
    let h = hash from t.pool (Int_array.nth t.ends set - from) in
    let i = free_slot slots (h land (Array.length slots - 1)) in
    slots.(i) <- set + 1;
    Int_array.put t.places set i
  done;
  t.slots <- slots

let store t slot =
  if t.pooled + t.drafted > Array.length t.pool then t.pool <- widened t.pool (t.pooled + t.drafted);
  Array.blit t.draft 0 t.pool t.pooled t.drafted;
  t.pooled <- t.pooled + t.drafted;
  Int_array.push t.ends t.pooled;
  Int_array.push t.places slot;
  t.slots.(slot) <- count t;
  let set = count t - 1 in
  if 2 * count t > Array.length t.slots then widen_slots t;
  set

let finish t =
  sort t;
  drop_repetitions t;
  let mask = Array.length t.slots - 1 in
  let rec look i =
    match t.slots.(i) with
    | 0 -> store t i
    | set when equals_draft t (set - 1) -> set - 1
    | _ -> look ((i + 1) land mask)
  in
  look (hash 0 t.draft t.drafted land mask)
