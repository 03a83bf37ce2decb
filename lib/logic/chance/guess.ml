open Enclosure

(* Guesses come nearer to the solution by rounds (modified policy iteration): one sweep finds the best rows, and
   then these are evaluated by pairs of sweeps, one up and one down. Of each pair the first one's change is
   looked at. Changes become a geometric sequence in the end, and what is changed is the same up to a factor: so
   the limit can be seen from far. Nothing that is proved depends on it. *)
type pace = {
  mutable sweeps : int;
  mutable rounds : int;
  mutable change : float;  (** the greatest one of the last pair *)
  mutable moved : float;  (** the sum of its changes *)
  mutable ratio : float;  (** of the last two sums *)
  mutable steady : int;  (** for how many pairs of sweeps the ratio has been nearly the same *)
  mutable rate : float;  (** the ratio when it last was so *)
  mutable least : float;  (** of the changes of the first sweeps of all rounds *)
  mutable since : int;  (** the round of that *)
  mutable early : int;  (** the number of sweeps at which ends are tried before they are near *)
  stride : float;
  mutable calm : float;  (** with a stride above 1: the least sum of changes so far *)
}

let long_stride = 1.5

let distance p change =
  if change = 0. then 0. else if p.rate >= 1. then infinity else change *. p.rate /. (1. -. p.rate)

let pair t part p =
  let relative = t.effort.relative and first = part.first and last = part.last in
  worked t (2 * size part);
  Rounded.remember t.r ~first ~last;
  let stride = p.stride in
  let change = Rounded.evaluate t.r ~first ~last ~forward:true ~relative ~stride in
  let moved = t.r.measure.(0) in
  ignore (Rounded.evaluate t.r ~first ~last ~forward:false ~relative ~stride);
  let ratio = if p.moved > 0. && p.moved < infinity then moved /. p.moved else 1. in
  p.steady <- (if Float.abs (ratio -. p.ratio) < 0.1 *. (1. -. ratio) then p.steady + 1 else 0);
  p.ratio <- ratio;
  if p.steady > 0 || ratio > p.rate then p.rate <- ratio;
  p.change <- change;
  p.moved <- moved;
  p.sweeps <- p.sweeps + 2;
  p.calm <- Float.min p.calm moved;
  if p.steady > 0 && stride = 1. then begin
    Rounded.go_on t.r ~first ~last ~factor:(ratio /. (1. -. ratio));
    p.steady <- 0;
    p.ratio <- 1.;
    p.moved <- infinity
  end

(* Floats do not get on when a sweep changes the last digits alone. *)
let stalled t part change =
  change = 0.
  || change
     <= 0x1p-49
             *. (if t.effort.relative then 1.
                 else
                   let greatest = ref 0. in
                   for v = part.first to part.last do
                     if t.r.guess.(v) > !greatest then greatest := t.r.guess.(v)
                   done;
                   !greatest)

let pairs = 12

(* Guesses that leap, or follow rows that are not the best, may go in circles. What does not get on after so many
   rounds goes on with the best rows alone, and this comes to the solution from wherever it is. *)
let patience = 500
let circling p = p.rounds - p.since > 2 * patience

(* One round; the change of its first sweep. *)
let round t part p ~target =
  let first = part.first and last = part.last in
  worked t (size part);
  let change = Rounded.improve t.r ~first ~last ~forward:(p.rounds land 1 = 0) ~relative:t.effort.relative in
  p.sweeps <- p.sweeps + 1;
  p.rounds <- p.rounds + 1;
  if change < p.least then begin
    p.least <- change;
    p.since <- p.rounds
  end;
  p.change <- infinity;
  p.moved <- infinity;
  p.ratio <- 1.;
  p.steady <- 0;
  let enough = Float.max (0.25 *. target) (0.25 *. change) in
  let rec go n =
    if n > 0 && not (stalled t part p.change) then begin
      pair t part p;
      if distance p p.change > enough then go (n - 1)
    end
  in
  if distance p change > target && not (stalled t part change) then
    if p.rounds - p.since < patience then go (Int.min pairs p.rounds);
  change

let paced t ~stride =
  {
    sweeps = 0;
    rounds = 0;
    change = infinity;
    moved = infinity;
    ratio = 1.;
    steady = 0;
    rate = 1.;
    least = infinity;
    since = 0;
    early = (if t.few then 64 else 256);
    stride;
    calm = infinity;
  }

let pace t = paced t ~stride:1.

(* Policy iteration by elimination: whether floats came to its end. *)
let directly t part =
  let first = part.first and last = part.last in
  let rec go n =
    worked t (2 * size part);
    Rounded.improve t.r ~first ~last ~forward:true ~relative:true <= 0x1p-44
    || (n > 0 && Direct.evaluate t.direct t.r ~first ~last && go (n - 1))
  in
  size part <= Direct.greatest && go 16

(* Numbers of steps s, guessed in so many sweeps at most until each is more than 1/2 + sum p s of any row. Where
   values come from far, changes wander through a component for many sweeps before they get less, and leaps do not
   help: they come several times as far with a stride above 1 (successive over-relaxation), if they do not grow by
   that. *)
let count_steps t part (r : Rounded.t) ~sweeps =
  let t = { t with r; effort = { t.effort with relative = false } } in
  let rec go p ~sweeps =
    round t part p ~target:0.25 <= 0.5
    || (p.sweeps < sweeps && (p.stride = 1. || p.moved <= 8. *. p.calm) && go p ~sweeps)
  in
  Krylov.approach t r part;
  let enough =
    go (pace t) ~sweeps:64
    || begin
      Array.fill r.guess part.first (size part) 0.;
      go (paced t ~stride:long_stride) ~sweeps
    end
  in
  (enough, t.work, t.next)

(* How much farther an end of a component may be for each step, if it is to be no farther than the gap. An end that
   is moved by a multiple of s, above, leaves each right side a margin, which is more than what the guess of the
   values lacks. Ends that are moved by a share of the value leave none in rows without a constant, and the sweeps
   that make one are many. Nothing when it takes more sweeps than allowed: some scheduler may stay for ever. *)
let per_step t part ~gap ~sweeps =
  let r =
    match t.steps with
    | Some r -> r
    | None ->
      let r = Rounded.steps t.r in
      t.steps <- Some r;
      r
  in
  let enough, work, next = count_steps t part r ~sweeps in
  t.work <- work;
  t.next <- next;
  if enough then begin
    let least = ref infinity in
    for v = part.first to part.last do
      let room = if t.effort.relative then gap *. t.r.guess.(v) else gap in
      if room < !least *. r.guess.(v) then least := room /. r.guess.(v)
    done;
    !least
  end
  else 0.

let least t part =
  let least = ref infinity in
  for v = part.first to part.last do
    if t.r.guess.(v) < !least then least := t.r.guess.(v)
  done;
  !least

(* Guesses begin with what is below or with what is above, with that which changes less in some sweeps. *)
let start t part p =
  let first = part.first and last = part.last in
  let settles begin_ =
    begin_ t.r ~first ~last;
    for n = 1 to 2 do
      worked t (size part);
      p.sweeps <- p.sweeps + 1;
      ignore (Rounded.improve t.r ~first ~last ~forward:(n land 1 = 0) ~relative:t.effort.relative)
    done;
    t.r.measure.(0)
  in
  let high = settles Rounded.begin_high in
  let low = settles Rounded.begin_low in
  if high < low then Rounded.begin_high t.r ~first ~last
