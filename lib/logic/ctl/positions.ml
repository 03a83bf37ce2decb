open Scc_exact

type position = { node : int; offset : Algebraic.t }

let start node = { node; offset = Algebraic.zero }
let is_inside p = Algebraic.compare_rat p.offset Rat.zero > 0

(* In [flow], ['\002'] says that the pieces are in the table. *)
type t = { at : Bytes.t; flow : Bytes.t; varied : (int, Pieces.t) Hashtbl.t }

let code v = if v then '\001' else '\000'
let is_yes c = not (Char.equal c '\000')

let make (g : Timed_graph.t) ~at ~along =
  let varied = Hashtbl.create 16 in
  let flow s =
    match Timed_graph.flow g s with
    | No_flow -> '\000'
    | Lasts _ | Forever ->
      let p = along s in
      if Pieces.is_constant p then code (Pieces.holds p 0)
      else begin
        Hashtbl.replace varied s p;
        '\002'
      end
  in
  let at = Bytes.init g.size (fun s -> code (at s)) in
  { at; flow = Bytes.init g.size flow; varied }

let constant (g : Timed_graph.t) v =
  { at = Bytes.make g.size (code v); flow = Bytes.make g.size (code v); varied = Hashtbl.create 1 }

let at t s = is_yes (Bytes.get t.at s)

let along t s =
  match Bytes.get t.flow s with
  | '\000' -> Pieces.constant false
  | '\001' -> Pieces.constant true
  | _ -> Hashtbl.find t.varied s

let mem t p = if is_inside p then Pieces.at (along t p.node) p.offset else at t p.node

let not_ t =
  let flip = function '\000' -> '\001' | '\001' -> '\000' | c -> c in
  let varied = Hashtbl.create (Hashtbl.length t.varied) in
  Hashtbl.iter (fun s p -> Hashtbl.replace varied s (Pieces.not_ p)) t.varied;
  { at = Bytes.map flip t.at; flow = Bytes.map flip t.flow; varied }

let map2 f a b =
  let n = Bytes.length a.at in
  let varied = Hashtbl.create 16 in
  let flow s =
    let p = Pieces.map2 f (along a s) (along b s) in
    if Pieces.is_constant p then code (Pieces.holds p 0)
    else begin
      Hashtbl.replace varied s p;
      '\002'
    end
  in
  {
    at = Bytes.init n (fun s -> code (f (at a s) (at b s)));
    flow = Bytes.init n flow;
    varied;
  }

let equal a b =
  a == b
  || Bytes.equal a.at b.at
     && Bytes.equal a.flow b.flow
     && Hashtbl.fold
       (fun s p same -> same && Pieces.equal p (Hashtbl.find b.varied s))
       a.varied true

let surely : Truth.t -> bool = function True -> true | False | Undecided _ -> false
let perhaps : Truth.t -> bool = function True | Undecided _ -> true | False -> false

let of_truth (g : Timed_graph.t) ~at ~along =
  let empty () =
    { at = Bytes.make g.size '\000'; flow = Bytes.make g.size '\000'; varied = Hashtbl.create 16 }
  in
  let low = empty () and high = empty () in
  let put set s p =
    if Pieces.is_constant p then Bytes.set set.flow s (code (Pieces.holds p 0))
    else begin
      Bytes.set set.flow s '\002';
      Hashtbl.replace set.varied s p
    end
  in
  for s = 0 to g.size - 1 do
    let v = at s in
    Bytes.set low.at s (code (surely v));
    Bytes.set high.at s (code (perhaps v));
    match (Timed_graph.flow g s, along) with
    | No_flow, _ -> ()
    | (Lasts _ | Forever), None ->
      Bytes.set low.flow s (code (surely v));
      Bytes.set high.flow s (code (perhaps v))
    | ((Lasts _ | Forever) as flow), Some along ->
      let timeline = along s (Timed_graph.extent flow) in
      put low s (Pieces.of_timeline surely timeline);
      put high s (Pieces.of_timeline perhaps timeline)
  done;
  if equal low high then (low, low) else (low, high)
