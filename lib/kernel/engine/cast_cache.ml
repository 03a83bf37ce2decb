open Scc_data
open Scc_exact
open Scc_rigid

type question = { one : Motion.t; two : Motion.t; span : Rat.t; grid : int; phase : Rat.t }

type entry = { hash : int; question : question; answer : Cast.outcome }

(* None has no number that is asked for. *)
type t = entry option Recent.t

let most = 1 lsl 13
let number = function Some e -> e.hash | None -> -1
let create () = Recent.create ~number ~none:None ~most

(* Solids are those of a model. *)
let same_motion (a : Motion.t) (b : Motion.t) =
  a == b
  || (a.solid == b.solid
      && Vec.equal a.centre b.centre
      && Rat.equal a.since b.since
      && Quaternion.equal a.turned b.turned
      && Vec.equal a.velocity b.velocity
      && Vec.equal a.spin b.spin
      && Vec.equal a.arm b.arm)

let same a b =
  a.grid = b.grid
  && Rat.equal a.span b.span
  && Rat.equal a.phase b.phase
  && same_motion a.one b.one
  && same_motion a.two b.two

let mix h k = (h * 1_000_003) lxor k

let hash_motion h (m : Motion.t) =
  mix (mix (mix (mix h (Vec.hash m.centre)) (Rat.hash m.since)) (Quaternion.hash m.turned)) (Vec.hash m.spin)

let hash q = hash_motion (hash_motion (mix (Rat.hash q.span) q.grid) q.one) q.two
let spread h = (h lxor (h lsr 20)) land max_int

let find memory cast one two ~span ~grid ~phase =
  let question = { one; two; span; grid; phase } in
  let hash = spread (hash question) in
  match Recent.get memory hash with
  | Some e when same e.question question -> e.answer
  | Some _ | None ->
    let answer = cast one two ~span ~grid ~phase in
    Recent.keep memory (Some { hash; question; answer });
    answer
