open Scc_exact
open Scc_calculus
open Behaviour

(* The definitions so far, the last first, and how many there are. *)
type book = { random : Random.State.t; mutable added : definition list; mutable count : int }

let define book body =
  let name = Printf.sprintf "New%d" book.count in
  book.added <- { name; body } :: book.added;
  book.count <- book.count + 1;
  call (book.count - 1)

let below book n = Random.State.int book.random n
let third k = Rat.make (Z.of_int k) (Z.of_int 3)

(* Tick := eps(1/3). Tick *)
let idle book = define book (delay (third 1) (call book.count))

(* Whether something may be left to chance here. To be sure, what is looked for is looked for everywhere. *)
let has_chance (defs : definitions) b =
  let rec within seen = function
    | Weak (_, { odds = Some _; _ }, _) -> true
    | Nil | Open _ | Weak _ | Strong _ -> false
    | Delay (_, b) | Wait (_, b) -> within seen b
    | Sum (b, c) -> within seen b || within seen c
    | Call k -> k >= Array.length defs || ((not (List.mem k seen)) && within (k :: seen) defs.(k).body)
  in
  within [] b

(* A law at the top of a behaviour. Twice the same is the same, but where chances would add. *)
let once book (defs : definitions) (b : t) =
  match (below book 9, b) with
  | (2 | 3), _ when has_chance defs b -> sum b nil
  | 0, _ -> sum b nil
  | 1, _ -> sum nil b
  | 2, _ -> sum b b
  | 3, _ -> sum b (define book b)
  | 4, _ -> define book b
  | 5, _ -> sum b (idle book)
  | 6, _ -> sum b (delay (third (1 + below book 5)) nil)
  | 7, Call k when k < Array.length defs -> defs.(k).body
  | 7, Sum (x, y) -> sum y x
  | 8, Delay (t, Sum (x, y)) -> sum (delay t x) (delay t y)
  | _, Delay (t, rest) ->
    let first = Rat.mul t (third 1) in
    delay first (delay (Rat.sub t first) rest)
  | _ -> delay Rat.zero b

(* Everywhere below, and then at the top. *)
let rec rewrite book defs (b : t) =
  let into = rewrite book defs in
  let inner : t =
    match b with
    | Nil | Call _ -> b
    | Open (p, c, rest) -> open_ p c (into rest)
    | Weak (c, { push; odds }, rest) -> weak ~push ?odds c (into rest)
    | Strong (l, push, rest) -> strong ~push l (into rest)
    | Delay (t, rest) -> delay t (into rest)
    | Wait (t, rest) -> wait t (into rest)
    | Sum (x, y) -> sum (into x) (into y)
  in
  if below book 2 = 0 then inner else once book defs inner

let with_behaviours f (s : State.t) =
  let leaf (l : State.leaf) = { l with behaviour = f l.behaviour } in
  State.make ~processes:(List.map (State.map_leaves leaf) (Array.to_list s.processes)) ~step:s.step ~time:s.time

let model seed (m : Model.t) s =
  let defs = m.definitions in
  let book = { random = Random.State.make [| seed |]; added = []; count = Array.length defs } in
  let changed = Array.map (fun d -> { d with body = rewrite book defs d.body }) defs in
  let s = with_behaviours (fun b -> fresh (rewrite book defs b.term)) s in
  ({ m with definitions = Array.append changed (Array.of_list (List.rev book.added)) }, s)

let waiting d s = with_behaviours (fun b -> fresh (sum b.term (delay d nil))) s

let without_behaviours s =
  let of_process (p : State.process) =
    State.with_lots (Option.map (Symmetry.mapped_lots ~summand:(fun _ -> nil)) p.lots) p
  in
  let s = with_behaviours (fun _ -> fresh nil) s in
  State.make ~processes:(List.map of_process (Array.to_list s.processes)) ~step:s.step ~time:s.time
