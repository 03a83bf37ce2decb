module V = Int_array

(* [order] holds the nodes of closed components from the beginning, in the order of closing, and the open ones
   from the end; both together are at most all. *)
type t = { number : V.t; order : V.t; mutable closed : int; mutable ordered : int }

(* The nodes being visited, with their edges that come next. *)
type calls = { mutable node : int array; mutable next : int array; mutable depth : int }

let push c v edge =
  let n = Array.length c.node in
  if c.depth = n then begin
    let grow a = Array.append a (Array.make (Int.max 16 n) 0) in
    c.node <- grow c.node;
    c.next <- grow c.next
  end;
  c.node.(c.depth) <- v;
  c.next.(c.depth) <- edge;
  c.depth <- c.depth + 1

(* The edges of a node are numbered one after the other from [enter] on, and [target] is negative after the last
   one. *)
let by_edges ~size ~inside ~enter ~target ~leave =
  let t = { number = V.make size (-1); order = V.make size (-1); closed = 0; ordered = 0 } in
  let index = V.make size (-1) and low = V.make size 0 in
  let calls = { node = [||]; next = [||]; depth = 0 } in
  let found = ref 0 and top = ref size in
  let discover v =
    V.set index v !found;
    V.set low v !found;
    incr found;
    decr top;
    V.set t.order !top v;
    push calls v (enter v)
  in
  let rec close v =
    let w = V.get t.order !top in
    incr top;
    V.set t.number w t.closed;
    V.set t.order t.ordered w;
    t.ordered <- t.ordered + 1;
    if not (Int.equal v w) then close v
  in
  let finish v =
    if V.get low v = V.get index v then begin
      close v;
      t.closed <- t.closed + 1
    end;
    leave v;
    calls.depth <- calls.depth - 1;
    if calls.depth > 0 then begin
      let parent = calls.node.(calls.depth - 1) in
      V.set low parent (Int.min (V.get low parent) (V.get low v))
    end
  in
  for root = 0 to size - 1 do
    if inside root && V.get index root < 0 then begin
      discover root;
      while calls.depth > 0 do
        let d = calls.depth - 1 in
        let v = calls.node.(d) and k = calls.next.(d) in
        let w = target k in
        if w < 0 then finish v
        else begin
          calls.next.(d) <- k + 1;
          let i = V.get index w in
          if i < 0 then begin
            if inside w then discover w
          end
          else if i < V.get low v && V.get t.number w < 0 then V.set low v i
        end
      done
    end
  done;
  t

(* The successors of all nodes being visited lie one after the other. *)
let compute ~size ~inside ~successors =
  let edges = V.buffer () in
  let enter v =
    let first = V.size edges in
    Array.iter (fun w -> if inside w then V.push edges w) (successors v);
    V.push edges (-1);
    first
  in
  let rec back_to_last () =
    if V.size edges > 0 && V.nth edges (V.size edges - 1) >= 0 then begin
      ignore (V.pop edges);
      back_to_last ()
    end
  in
  let leave _ =
    ignore (V.pop edges);
    back_to_last ()
  in
  by_edges ~size ~inside ~enter ~target:(V.nth edges) ~leave

let of_graph ~size ~inside ~first ~targets =
  by_edges ~size ~inside ~enter:(V.get first) ~target:(V.get targets) ~leave:ignore

let count t = t.closed
let number t v = V.get t.number v
let numbers t = t.number

let iter t f =
  for i = 0 to t.ordered - 1 do
    let v = V.get t.order i in
    f (V.get t.number v) v
  done
