open Scc_data
open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_semantics

(* Where the second body is from the first, and how both move. *)
type question = { one : Solid.t; two : Solid.t; offset : Vec.t; v : Vec.t; u : Vec.t; span : Rat.t }
type entry = { hash : int; question : question; answer : Geometry.paths }

(* None has no number that is asked for. *)
type t = entry option Recent.t

let most = 1 lsl 12
let number = function Some e -> e.hash | None -> -1
let create () = Recent.create ~number ~none:None ~most

(* Solids are those of a model. *)
let same a b =
  a.one == b.one
  && a.two == b.two
  && Vec.equal a.offset b.offset
  && Vec.equal a.v b.v && Vec.equal a.u b.u && Rat.equal a.span b.span

let mix h k = (h * 1_000_003) lxor k

let hash q =
  let h = mix (mix q.one.id q.two.id) (Vec.hash q.offset) in
  let h = mix (mix h (Vec.hash q.v)) (Vec.hash q.u) in
  (h lxor (h lsr 20)) land max_int

let find memory paths (one : Placed.t) (two : Placed.t) ~span v u =
  let question = { one = one.solid; two = two.solid; offset = Vec.sub two.at one.at; v; u; span } in
  let hash = hash question in
  match Recent.get memory hash with
  | Some e when same e.question question -> e.answer
  | Some _ | None ->
    let answer = paths one two ~span v u in
    Recent.keep memory (Some { hash; question; answer });
    answer
