open Scc_ctl
open Scc_exact

let rational a =
  match Algebraic.to_rat a with Some r -> r | None -> failwith "an offset that is not rational"

let cell (g : Small.t) (p : Positions.position) =
  let x = Rat.div (rational p.offset) g.unit in
  if Rat.sign x = 0 then None
  else
    let k = Z.to_int (Rat.floor x) in
    let i = if Rat.is_integer x then (2 * k) - 1 else 2 * k in
    (* The last cell of a ray stands for all that come after it. *)
    Some (Int.min i (Small.cells g.nodes.(p.node) - 1))

type piece = { position : Positions.position; from : Rat.t; until : Rat.t option }

exception Wrong of string

let wrong text = raise (Wrong text)
let length (g : Small.t) s = match g.nodes.(s).flow with
  | No_flow -> wrong "time passes where there is no flow"
  | Lasts (d, _) -> Some (Rat.mul g.unit (Rat.of_int d))
  | Ray _ -> None

(* The pieces of a flow after an offset, up to another one or to the end; [time] is the elapsed time at the
   first. *)
let flow (g : Small.t) s ~after ~before time =
  if not g.nodes.(s).known then wrong "a way out of a node that is not known";
  let elapsed x = Rat.add time (Rat.sub x after) in
  let ends = match before with Some _ -> before | None -> length g s in
  let rec go low acc =
    let k = Z.to_int (Rat.floor (Rat.div low g.unit)) in
    (* The last cell of a ray goes on for ever. *)
    let last = Option.is_none ends && 2 * k >= Small.cells g.nodes.(s) - 1 in
    let high = Rat.mul g.unit (Rat.of_int (k + 1)) in
    let high =
      match ends with
      | None -> if last then None else Some high
      | Some e -> Some (Rat.min e high)
    in
    let inside =
      match high with
      | None -> Rat.add low g.unit
      | Some h -> Rat.div (Rat.add low h) (Rat.of_int 2)
    in
    let open_piece =
      { position = { node = s; offset = Algebraic.of_rat inside }; from = elapsed low;
        until = Option.map elapsed high }
    in
    match high with
    | None -> List.rev (open_piece :: acc)
    | Some h when (match ends with Some e -> Rat.equal e h | None -> false) -> List.rev (open_piece :: acc)
    | Some h ->
      let instant =
        { position = { node = s; offset = Algebraic.of_rat h }; from = elapsed h; until = Some (elapsed h) }
      in
      go h (instant :: open_piece :: acc)
  in
  (match ends with Some e when Rat.compare after e >= 0 -> wrong "an offset after the end of the flow" | _ -> ());
  go after []

let point position time = { position; from = time; until = Some time }

let step (g : Small.t) (s : Run.step) at offset time =
  if not (Int.equal s.source at) then wrong "a step from elsewhere";
  if not g.nodes.(at).known then wrong "a step from a node that is not known";
  match s.move with
  | Edge k ->
    if Rat.sign offset > 0 then wrong "an edge inside a flow";
    let t = List.nth g.nodes.(at).edges k in
    ([ point (Positions.start t) time ], t, time)
  | Flow k -> (
      match g.nodes.(at).flow with
      | No_flow | Ray _ -> wrong "the end of a flow that has none"
      | Lasts (d, targets) ->
        let t = List.nth targets k in
        let d = Rat.mul g.unit (Rat.of_int d) in
        let later = Rat.add time (Rat.sub d offset) in
        (flow g at ~after:offset ~before:None time @ [ point (Positions.start t) later ], t, later))

(* From an offset of a flow, at this time, to a later one before the end of the flow. *)
let inside g at ~after:offset time until =
  let x = rational until in
  (match length g at with Some d when Rat.compare x d >= 0 -> wrong "not inside the flow" | _ -> ());
  if Rat.equal x offset then []
  else if Rat.compare x offset < 0 then wrong "the end of the run is before its start"
  else
    let between = flow g at ~after:offset ~before:(Some x) time in
    between @ [ point { node = at; offset = until } (Rat.add time (Rat.sub x offset)) ]

let walk g ~rounds (r : Run.t) =
  let start = rational r.start.offset in
  let go (pieces, at, offset, time) s =
    let more, at, time = step g s at offset time in
    (pieces @ more, at, Rat.zero, time)
  in
  let first = [ point r.start Rat.zero ] in
  let (pieces, at, offset, time) as state =
    List.fold_left go (first, r.start.node, start, Rat.zero) r.steps
  in
  if not (Int.equal at r.last) then wrong "it does not lead to its last node";
  match r.finish with
  | At_state ->
    if Rat.sign offset > 0 then wrong "it ends at a node, but is inside a flow";
    pieces
  | Stops ->
    if not (Timed_graph.is_dead_end (Small.graph g) at) then wrong "no dead end";
    pieces
  | Rests ->
    if Option.is_some (length g at) then wrong "it does not rest there";
    pieces @ flow g at ~after:offset ~before:None time
  | Passes left -> pieces @ inside g at ~after:offset time left
  | During { moment; sample } ->
    let c = Algebraic.compare moment.offset sample in
    if not (if moment.attained then c = 0 else c < 0) then wrong "the sample is not at its moment";
    pieces @ inside g at ~after:offset time sample
  | Repeats k ->
    let cycle = List.filteri (fun i _ -> i >= k) r.steps in
    (match cycle with
     | s :: _ when Int.equal s.source at && Rat.sign offset = 0 -> ()
     | _ -> wrong "it does not come back");
    let rec again n state =
      if n = 0 then state else again (n - 1) (List.fold_left go state cycle)
    in
    let pieces, _, _, _ = again (rounds - 1) state in
    pieces

let pieces g ~rounds r = match walk g ~rounds r with l -> Ok l | exception Wrong text -> Error text

type window = { low : Rat.t; high : Rat.t option }
type verdict = Met | Broken | Past | Open

let in_window w p =
  match p.until with
  | Some t when Rat.equal t p.from ->
    Rat.compare t w.low >= 0 && (match w.high with None -> true | Some h -> Rat.compare t h <= 0)
  | _ ->
    (match w.high with None -> true | Some h -> Rat.compare p.from h < 0)
    && match p.until with None -> true | Some t -> Rat.compare t w.low > 0

let is_past w p ~instant =
  match w.high with
  | None -> false
  | Some h -> if instant then Rat.compare p.from h > 0 else Rat.compare p.from h >= 0

let rec until w ~f ~g = function
  | [] -> (Open, [])
  | p :: rest ->
    let instant = match p.until with Some t -> Rat.equal t p.from | None -> false in
    let met = g p.position && in_window w p in
    if is_past w p ~instant then (Past, rest)
    else if instant && met then (Met, rest)
    else if not (f p.position) then (Broken, rest)
    else if met then (Met, rest)
    else until w ~f ~g rest
