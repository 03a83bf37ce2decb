open Scc_exact

type t = {
  slots : int array;  (** what they hold; of one that is not remembered, nothing *)
  present : Local.alone array;
  urgent : Local.move list;
  weak : Local.move list;
  wait : Rat.t option;
  velocity : int;
  rest : bool;
  mutable later : Rat.t * int array;  (** what has changed after the last time that was asked for *)
}

let present s = s.present
let urgent s = s.urgent
let weak s = s.weak
let wait s = s.wait
let rest s = s.rest

(* Instead of the number of the velocity that all have. *)
let of_nobody = -1
let several = -2

let[@inline] both v w = if v = w || w = of_nobody then v else if v = of_nobody then w else several
let in_relative_motion s s' = both s.velocity s'.velocity = several

let sooner wait (a : Local.alone) =
  match (a.nature.wait, wait) with
  | None, _ -> wait
  | other, None -> other
  | Some d, Some e -> if d == e || Rat.compare e d <= 0 then wait else a.nature.wait

(* After no time all are who they were. *)
let no_time = (Rat.zero, [||])

let of_present (present : Local.alone array) =
  let urgent = ref [] and weak = ref [] and wait = ref None and velocity = ref of_nobody and rest = ref true in
  for i = 0 to Array.length present - 1 do
    let a = Array.unsafe_get present i in
    (match a.urgent with [] -> () | moves -> urgent := List.rev_append moves !urgent);
    (match a.weak with [] -> () | moves -> weak := List.rev_append moves !weak);
    wait := sooner !wait a;
    velocity := both !velocity a.body.velocity;
    if not a.rests then rest := false
  done;
  { slots = [||]; present; urgent = !urgent; weak = !weak; wait = !wait; velocity = !velocity; rest = !rest;
    later = no_time }

let nobody = of_present [||]

let changes local d s =
  let rec from i changes =
    if i < 0 then Array.of_list changes
    else
      let a = Array.unsafe_get s.present i in
      let later = Local.after local d a in
      from (i - 1)
        (if later = a.body.number then changes else Catalogue.first_leaf a.body.process :: later :: changes)
  in
  from (Array.length s.present - 1) []

let after local d s =
  let known, changed = s.later in
  if known == d || Rat.equal known d then changed
  else begin
    let changed = changes local d s in
    s.later <- (d, changed);
    changed
  end

(* {1 Remembered} *)

type memory = {
  local : Local.t;
  first : int;
  beyond : int;
  mutable seen : int array;  (** by places: the hash of what has been there last *)
  mutable sections : t array;
  mutable kept : int;  (** since there have been so many places *)
}

let first_size = 1 lsl 6
let most = 1 lsl 12

let memory local ~first ~beyond =
  { local; first; beyond; seen = Array.make first_size (-1); sections = Array.make first_size nobody; kept = 0 }

let hash (tuple : int array) first beyond =
  let h = ref 0 in
  for i = first to beyond - 1 do
    h := (!h * 0x1E3779B97F4A7C15) + Array.unsafe_get tuple i
  done;
  (!h lxor (!h lsr 32)) land max_int

(* Whether the slots from [first] on hold these. *)
let are_held (slots : int array) (tuple : int array) first =
  let n = Array.length slots in
  let k = ref 0 in
  while !k < n && Array.unsafe_get slots !k = Array.unsafe_get tuple (first + !k) do
    incr k
  done;
  !k = n

let made m (tuple : int array) =
  let rec count i n =
    if i = m.beyond then n
    else count (i + 1) (if Array.unsafe_get tuple i = Catalogue.nobody then n else n + 1)
  in
  let present = Array.make (count m.first 0) (Local.nobody m.local) in
  let rec fill i n =
    if n < Array.length present then begin
      let number = Array.unsafe_get tuple i in
      if number = Catalogue.nobody then fill (i + 1) n
      else begin
        Array.unsafe_set present n (Local.alone m.local number);
        fill (i + 1) (n + 1)
      end
    end
  in
  fill m.first 0;
  of_present present

let[@inline] place slots h = h land (Array.length slots - 1)

(* Made to the end before they take the place of the old ones: work may be given up anywhere. *)
let enlarge m =
  let size = 2 * Array.length m.seen in
  let seen = Array.make size (-1) and sections = Array.make size nobody in
  Array.iter (fun h -> if h >= 0 then seen.(place seen h) <- h) m.seen;
  let put s = if s != nobody then sections.(place sections (hash s.slots 0 (Array.length s.slots))) <- s in
  Array.iter put m.sections;
  m.seen <- seen;
  m.sections <- sections;
  m.kept <- 0

let keep m h s =
  if m.kept >= Array.length m.seen && Array.length m.seen < most then enlarge m;
  m.kept <- m.kept + 1;
  m.sections.(place m.sections h) <- s

let look m tuple =
  let h = hash tuple m.first m.beyond in
  let i = place m.seen h in
  let known = Array.unsafe_get m.sections i in
  if known != nobody && are_held known.slots tuple m.first then known
  else begin
    let s = made m tuple in
    if Array.unsafe_get m.seen i = h then begin
      let s = { s with slots = Array.sub tuple m.first (m.beyond - m.first) } in
      keep m h s;
      s
    end
    else begin
      Array.unsafe_set m.seen i h;
      s
    end
  end
