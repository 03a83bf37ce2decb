let components (g : Graph.t) =
  let index = Ints.make g.size (* when it was found, from 1 *)
  and low = Ints.make g.size
  and component = Ints.make g.size (* from 1; 0 while it has none *)
  and cursor = Ints.make g.size (* the next edge to look at *)
  and open_ = Ints.buffer () (* found, and without a component *)
  and path = Ints.buffer () in
  let found = ref 0 and count = ref 0 in
  let enter s =
    incr found;
    Ints.set index s !found;
    Ints.set low s !found;
    Ints.set cursor s (Ints.get g.first s);
    Ints.push open_ s;
    Ints.push path s
  in
  let lower s x = if x < Ints.get low s then Ints.set low s x in
  let rec close root =
    let s = Ints.pop open_ in
    Ints.set component s !count;
    if s <> root then close root
  in
  let leave s =
    ignore (Ints.pop path);
    if Ints.get low s = Ints.get index s then begin
      incr count;
      close s
    end;
    if Ints.size path > 0 then lower (Ints.nth path (Ints.size path - 1)) (Ints.get low s)
  in
  (* silent edges are the first ones of a state *)
  let step s =
    let e = Ints.get cursor s in
    if e < Ints.get g.first (s + 1) && Graph.is_tau (Ints.get g.label e) then begin
      Ints.set cursor s (e + 1);
      let t = Ints.get g.target e in
      if Ints.get index t = 0 then enter t
      else if Ints.get component t = 0 then lower s (Ints.get index t)
    end
    else leave s
  in
  for s = 0 to g.size - 1 do
    if Ints.get index s = 0 then enter s;
    while Ints.size path > 0 do
      step (Ints.nth path (Ints.size path - 1))
    done
  done;
  for s = 0 to g.size - 1 do
    Ints.set component s (Ints.get component s - 1)
  done;
  (component, !count)

let collapse g =
  let component, size = components g in
  (Graph.merge g (Ints.get component) ~size ~drop_silent_loops:true, component)
