type t = { g : Grid.t; ring : int array; next : int array; before : int array; blunt : bool array }

let turn t a b c = Grid.orient t.g t.ring.(a) t.ring.(b) t.ring.(c)

(* Some corner in a triangle is one that is not convex, or its neighbours would be in it as well. *)
let is_ear t b =
  let a = t.before.(b) and c = t.next.(b) in
  let outside p = turn t a b p < 0 || turn t b c p < 0 || turn t c a p < 0 in
  let rec clear p = p = a || ((not t.blunt.(p)) || outside p) && clear t.next.(p) in
  (not t.blunt.(b)) && clear t.next.(c)

let update t b = t.blunt.(b) <- turn t t.before.(b) b t.next.(b) <= 0

let triangles g ring =
  let n = Array.length ring in
  let around step = Array.init n (fun k -> (k + step) mod n) in
  let t = { g; ring; next = around 1; before = around (n - 1); blunt = Array.make n false } in
  Array.iteri (fun k _ -> update t k) ring;
  let triangle b = [| ring.(t.before.(b)); ring.(b); ring.(t.next.(b)) |] in
  (* [tried] corners in a row up to b are no ears. After a cut the corner after the next one is tried: so triangles
     do not all gather at one corner. *)
  let rec cut left tried b found =
    if left = 3 then triangle b :: found
    else if tried > left then Scc_base.Bug.fail __POS__ "a polygon without an ear"
    else if is_ear t b then begin
      let a = t.before.(b) and c = t.next.(b) in
      let ear = triangle b in
      t.next.(a) <- c;
      t.before.(c) <- a;
      update t a;
      update t c;
      cut (left - 1) 0 t.next.(c) (ear :: found)
    end
    else cut left (tried + 1) t.next.(b) found
  in
  List.rev (cut n 0 0 [])
