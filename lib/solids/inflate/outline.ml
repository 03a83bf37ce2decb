open Scc_data

type place = int * int
type loop = place array

let unit = Front.unit
let half = unit / 2

(* {1 Tracing} *)

(* A corner of the outline is half-way between a pixel inside, (i, j), and the one outside in direction d: 0 right,
   1 down, 2 left, 3 up, clockwise on the screen. *)
let dx = [| 1; 0; -1; 0 |]
let dy = [| 0; 1; 0; -1 |]

(* The next corner with the shape on the right: at (i, j), looking outward to d, the walk goes on to the side d
   + 1. *)
let next s (i, j, d) =
  let e = (d + 1) land 3 in
  let i1 = i + dx.(e) and j1 = j + dy.(e) in
  if not (Silhouette.is_inside s i1 j1) then (i, j, e)
  else
    let i2 = i1 + dx.(d) and j2 = j1 + dy.(d) in
    if Silhouette.is_inside s i2 j2 then (i2, j2, (d + 3) land 3) else (i1, j1, d)

let place (i, j, d) = ((unit * i) + (half * dx.(d)), (unit * j) + (half * dy.(d)))

let trace (s : Silhouette.t) =
  let seen = Array.init 4 (fun _ -> Bytes.make (s.width * s.height) '\000') in
  let loops = ref [] in
  let follow start =
    let rec go corner found =
      let i, j, d = corner in
      let index = (j * s.width) + i in
      if Bytes.get seen.(d) index <> '\000' then found
      else begin
        Bytes.set seen.(d) index '\001';
        go (next s corner) (place corner :: found)
      end
    in
    (* The last one first: the walk is clockwise on the screen around the shape. *)
    loops := Array.of_list (go start []) :: !loops
  in
  (* The first pixel in the order of rows is on the outer outline. *)
  for j = 0 to s.height - 1 do
    for i = 0 to s.width - 1 do
      if Silhouette.is_inside s i j then
        for d = 0 to 3 do
          if
            (not (Silhouette.is_inside s (i + dx.(d)) (j + dy.(d))))
            && Bytes.get seen.(d) ((j * s.width) + i) = '\000'
          then follow (i, j, d)
        done
    done
  done;
  List.rev !loops

let corners loops = List.fold_left (fun n loop -> n + Array.length loop) 0 loops

(* {1 Simplification} *)

type simplified = { loops : loop list; off : int }

(* All corners of all loops in one row; each knows the corners before and after it that are left. *)
type chain = {
  places : place array;
  before : int array;
  after : int array;
  follows : int array;  (** the next one of the original loop *)
  loop : int array;
  left : int array;  (** how many corners each loop has left *)
  gone : Bytes.t;
  taken : Bytes.t;  (** of the multiples of half a pixel in the plane: whether a corner is there *)
  columns : int;
}

let slot c (x, y) = (((y + half) / half) * c.columns) + ((x + half) / half)

let chain (s : Silhouette.t) loops =
  let places = Array.concat loops in
  let n = Array.length places in
  let before = Array.make n 0 and after = Array.make n 0 and loop = Array.make n 0 in
  let start = ref 0 in
  List.iteri
    (fun l corners ->
       let m = Array.length corners in
       for k = 0 to m - 1 do
         after.(!start + k) <- !start + ((k + 1) mod m);
         before.(!start + k) <- !start + ((k + m - 1) mod m);
         loop.(!start + k) <- l
       done;
       start := !start + m)
    loops;
  let columns = (2 * s.width) + 2 in
  let c =
    {
      places; before; after; loop; columns;
      follows = Array.copy after;
      left = Array.of_list (List.map Array.length loops);
      gone = Bytes.make n '\000';
      taken = Bytes.make (columns * ((2 * s.height) + 2)) '\000';
    }
  in
  Array.iter (fun p -> Bytes.set c.taken (slot c p) '\001') places;
  c

(* How far the original line between the neighbours of v, without v, is from the segment between them: the root of
   n/d eighths of a pixel, in 1/256 pixel, rounded up. Each of the two lines is within the greatest distance of a
   corner of the original one from the segment. *)
let offset c v =
  let a = c.before.(v) and b = c.after.(v) in
  let ax, ay = c.places.(a) and bx, by = c.places.(b) in
  let d = ((bx - ax) * (bx - ax)) + ((by - ay) * (by - ay)) in
  let line = ref 0 and ends = ref 0 in
  let k = ref c.follows.(a) in
  while !k <> b do
    let x, y = c.places.(!k) in
    let along = ((x - ax) * (bx - ax)) + ((y - ay) * (by - ay)) in
    if along < 0 then ends := max !ends (((x - ax) * (x - ax)) + ((y - ay) * (y - ay)))
    else if along > d then ends := max !ends (((x - bx) * (x - bx)) + ((y - by) * (y - by)))
    else line := max !line (abs (Front.cross ax ay bx by x y));
    k := c.follows.(!k)
  done;
  let per = Relief.quanta / unit in
  let squared = Z.cdiv (Z.mul (Z.mul (Z.of_int !line) (Z.of_int !line)) (Z.of_int (per * per))) (Z.of_int d) in
  Z.to_int (Relief.root_up (Z.max squared (Z.of_int (!ends * per * per))))

(* No corner is in the triangle of v and its neighbours, its sides included: then the line that passes v by is as
   simple as the one before. *)
let free c v =
  let ax, ay = c.places.(c.before.(v)) and bx, by = c.places.(v) and ex, ey = c.places.(c.after.(v)) in
  let turn = Front.cross ax ay bx by ex ey in
  let sign = if turn < 0 then -1 else 1 in
  let own p = p = (ax, ay) || p = (bx, by) || p = (ex, ey) in
  let within x y =
    sign * Front.cross ax ay bx by x y >= 0
    && sign * Front.cross bx by ex ey x y >= 0
    && sign * Front.cross ex ey ax ay x y >= 0
  in
  let low a b c = Int.min a (Int.min b c) and high a b c = Int.max a (Int.max b c) in
  let x0 = low ax bx ex and x1 = high ax bx ex and y1 = high ay by ey in
  let rec rows y = y > y1 || (columns y x0 && rows (y + half))
  and columns y x =
    x > x1
    || ((Bytes.get c.taken (slot c (x, y)) = '\000' || own (x, y) || not (within x y)) && columns y (x + half))
  in
  rows (low ay by ey)

let simplify s ~most loops =
  let c = chain s loops in
  let n = Array.length c.places in
  let order (a, v, _) (b, w, _) = match Int.compare a b with 0 -> Int.compare v w | o -> o in
  let heap = Heap.create ~near:(fun (a, _, _) -> float_of_int a) ~compare:order in
  let version = Array.make n 0 in
  let put v = Heap.add heap (offset c v, v, version.(v)) in
  for v = 0 to n - 1 do put v done;
  let remaining = ref n and off = ref 0 in
  let remove cost v =
    off := max !off cost;
    decr remaining;
    Bytes.set c.gone v '\001';
    Bytes.set c.taken (slot c c.places.(v)) '\000';
    c.left.(c.loop.(v)) <- c.left.(c.loop.(v)) - 1;
    let a = c.before.(v) and b = c.after.(v) in
    c.after.(a) <- b;
    c.before.(b) <- a;
    List.iter (fun w -> version.(w) <- version.(w) + 1; put w) [ a; b ]
  in
  (* What was in the way of some may have gone since: they are tried again as long as that helps. *)
  let rec go removed blocked =
    match Heap.first heap with
    | Some (cost, v, at) when cost = 0 || !remaining > most ->
      Heap.drop_first heap;
      if Bytes.get c.gone v <> '\000' || at <> version.(v) || c.left.(c.loop.(v)) <= 3 then go removed blocked
      else if free c v then begin remove cost v; go true blocked end
      else go removed (v :: blocked)
    | _ ->
      if removed && blocked <> [] && !remaining > most then begin
        let again v =
          if Bytes.get c.gone v = '\000' then begin
            version.(v) <- version.(v) + 1;
            put v
          end
        in
        List.iter again blocked;
        go false []
      end
  in
  go false [];
  let kept start m = List.filter (fun v -> Bytes.get c.gone v = '\000') (List.init m (fun k -> start + k)) in
  let _, loops =
    List.fold_left
      (fun (start, found) corners ->
         let m = Array.length corners in
         (start + m, Array.of_list (List.map (fun v -> c.places.(v)) (kept start m)) :: found))
      (0, []) loops
  in
  { loops = List.rev loops; off = !off }
