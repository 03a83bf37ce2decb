module V = Int_array

(* [order] holds the nodes of closed components from the beginning, in the order of closing, and the open ones
   from the end; both together are at most all. *)
type t = { number : V.t; order : V.t; mutable closed : int; mutable ordered : int }

(* The nodes being visited, with their successors and which comes next. *)
type calls = {
  mutable node : int array;
  mutable next : int array;
  mutable ways : int array array;
  mutable depth : int;
}

let push c v ways =
  let n = Array.length c.node in
  if c.depth = n then begin
    let grow a default = Array.append a (Array.make (Int.max 16 n) default) in
    c.node <- grow c.node 0;
    c.next <- grow c.next 0;
    c.ways <- grow c.ways [||]
  end;
  c.node.(c.depth) <- v;
  c.next.(c.depth) <- 0;
  c.ways.(c.depth) <- ways;
  c.depth <- c.depth + 1

let compute ~size ~inside ~successors =
  let t = { number = V.make size (-1); order = V.make size (-1); closed = 0; ordered = 0 } in
  let index = V.make size (-1) and low = V.make size 0 in
  let calls = { node = [||]; next = [||]; ways = [||]; depth = 0 } in
  let found = ref 0 and top = ref size in
  let discover v =
    V.set index v !found;
    V.set low v !found;
    incr found;
    decr top;
    V.set t.order !top v;
    push calls v (successors v)
  in
  let rec close v =
    let w = V.get t.order !top in
    incr top;
    V.set t.number w t.closed;
    V.set t.order t.ordered w;
    t.ordered <- t.ordered + 1;
    if not (Int.equal v w) then close v
  in
  let leave v =
    if V.get low v = V.get index v then begin
      close v;
      t.closed <- t.closed + 1
    end;
    calls.ways.(calls.depth - 1) <- [||];
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
        if k = Array.length calls.ways.(d) then leave v
        else begin
          calls.next.(d) <- k + 1;
          let w = calls.ways.(d).(k) in
          if inside w then
            if V.get index w < 0 then discover w
            else if V.get t.number w < 0 then V.set low v (Int.min (V.get low v) (V.get index w))
        end
      done
    end
  done;
  t

let count t = t.closed
let number t v = V.get t.number v
let numbers t = t.number

let iter t f =
  for i = 0 to t.ordered - 1 do
    let v = V.get t.order i in
    f (V.get t.number v) v
  done
