(* Seconds of work that a request is to be worth, and those that it has to be; and how many states are in one at
   most, and at least while another is under way. *)
let batch_seconds = 0.002
let message_seconds = 50e-6
let most_states = 2048
let few_states = 64

(* Seconds that a state is to take, for others to be of use. *)
let worth = 2.5e-6

(* What is told costs this process about so many times what is measured of it, as caches and the garbage collector
   have to do with it, too. *)
let safety = 3.

(* Of so many states with numbers one after the other, a power of two, the first few are found here. *)
let stretch = 64

(* Of states in large requests, one of so many is timed for all. *)
let one_of = 16

(* A mean of fewer says little; what is older than so many counts half. *)
let enough = 100
let many = 1 lsl 15

type mean = { mutable seconds : float; mutable count : int }

type t = {
  now : unit -> float;
  find : mean;
  tell : mean;  (** and hear *)
  mutable here : int;  (** how many of each {!stretch} *)
  mutable batch : int;
  mutable least : int;
  mutable since : int;  (** states of which nothing was heard, since that was tried *)
}

let no_mean () = { seconds = 0.; count = 0 }
let create ~now = { now; find = no_mean (); tell = no_mean (); here = 0; batch = 8; least = 1; since = 0 }
let each m = m.seconds /. float_of_int m.count

let count_one m =
  m.count <- m.count + 1;
  if m.count > many then begin
    m.count <- m.count / 2;
    m.seconds <- m.seconds /. 2.
  end

(* Clocks may be set back. *)
let timed b m ~times work =
  let start = b.now () in
  let result = work () in
  m.seconds <- m.seconds +. (float_of_int times *. Float.max 0. (b.now () -. start));
  result

(* {1 What is measured} *)

let try_again b =
  b.since <- b.since + 1;
  if b.here = stretch && b.since > many then begin
    b.here <- stretch - 1;
    b.since <- 0
  end

(* To ask a clock takes about a twentieth of a microsecond, and some states take less than one. *)
let finding b work =
  let times = if b.find.count < enough || each b.find > 20e-6 then 1 else one_of in
  let result = if b.find.count land (times - 1) = 0 then timed b b.find ~times work else work () in
  count_one b.find;
  try_again b;
  result

let pays b = b.find.seconds > worth *. float_of_int b.find.count
let telling b work = timed b b.tell ~times:1 work

let hearing b i work =
  let times = if b.batch < few_states then 1 else one_of in
  let result = if i land (times - 1) = 0 then timed b b.tell ~times work else work () in
  count_one b.tell;
  b.since <- 0;
  result

let waited b = b.here <- Int.min (stretch - 1) (b.here + 1)

(* How many times as much it costs to tell of a state as to find what is told; 0, as long as that is not known. *)
let cost b seconds =
  let found = if b.find.count >= enough then each b.find else seconds in
  if b.tell.count >= enough then safety *. each b.tell /. found else 0.

(* From so many times on it is clear that nothing is to be told, once so many states have been: the first ones
   bring much with them that others do not have to. *)
let clear = 2.
let told_for_sure = 1024

let answered b ~states ~waited ~worked =
  let seconds = Float.max 1e-7 (worked /. float_of_int states) in
  let cost = cost b seconds in
  if cost > clear && b.tell.count >= told_for_sure then b.here <- Int.min stretch (1 + (2 * b.here))
  else if cost > 1. then b.here <- Int.min stretch (b.here + 1)
  else if waited > worked /. 4. then b.here <- Int.max 0 (b.here - 1);
  b.batch <- Int.max 1 (Int.min most_states (int_of_float (batch_seconds /. seconds)));
  b.least <- Int.max 1 (Int.min (b.batch / 4) (int_of_float (message_seconds /. seconds)))

(* {1 What follows} *)

let is_here b i = i land (stretch - 1) < b.here
let batch b = b.batch
let least b = b.least
let least_ahead b = Int.min few_states b.batch
let between_looks b = Int.max 1 (b.batch / 32)
