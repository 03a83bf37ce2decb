open Scc_geometry

type t = {
  flight : Flight.t;
  p : float array;
  va : int array;
  vb : int array;
  weight : float array;
  n : float array;
  shift : float array;
  mutable count : int;
}

let make flight =
  {
    flight;
    p = Array.make 12 0.;
    va = [| 0; 0; 0; 0 |];
    vb = [| 0; 0; 0; 0 |];
    weight = [| 1.; 0.; 0.; 0. |];
    n = [| 1.; 0.; 0. |];
    shift = [| 0.; 0.; 0. |];
    count = 0;
  }

type found = Apart of float | Near

(* All places are below the lengths of the arrays: corners are numbered 0 to 3, vertices come from the topology of
   their solid. *)
let[@inline] get (a : float array) i = Array.unsafe_get a i
let[@inline] set (a : float array) i x = Array.unsafe_set a i x

(* {1 Corners} *)

(* Corner k := vertex j of B less vertex i of A. *)
let place s k i j =
  let f = s.flight in
  let a = f.a.now and b = f.b.now and sa = f.a.solid.shadow and sb = f.b.solid.shadow in
  let ax = get sa.xs i and ay = get sa.ys i and az = get sa.zs i in
  let bx = get sb.xs j and by = get sb.ys j and bz = get sb.zs j in
  s.va.(k) <- i;
  s.vb.(k) <- j;
  let p = s.p and at = 3 * k in
  set p at
    (get f.here 0 +. get s.shift 0
     +. (b.ex +. ((b.xx *. bx) +. (b.xy *. by) +. (b.xz *. bz)))
     -. (a.ex +. ((a.xx *. ax) +. (a.xy *. ay) +. (a.xz *. az))));
  set p (at + 1)
    (get f.here 1 +. get s.shift 1
     +. (b.ey +. ((b.yx *. bx) +. (b.yy *. by) +. (b.yz *. bz)))
     -. (a.ey +. ((a.yx *. ax) +. (a.yy *. ay) +. (a.yz *. az))));
  set p (at + 2)
    (get f.here 2 +. get s.shift 2
     +. (b.ez +. ((b.zx *. bx) +. (b.zy *. by) +. (b.zz *. bz)))
     -. (a.ez +. ((a.zx *. ax) +. (a.zy *. ay) +. (a.zz *. az))))

(* The vertex that is highest along the vector [n], times [sign]: uphill from [start], or from where the compass
   points. *)
let highest (f : Flight.body) (n : float array) sign start =
  let r = f.now in
  let nx = sign *. get n 0 and ny = sign *. get n 1 and nz = sign *. get n 2 in
  let dx = (r.xx *. nx) +. (r.yx *. ny) +. (r.zx *. nz) in
  let dy = (r.xy *. nx) +. (r.yy *. ny) +. (r.zy *. nz) in
  let dz = (r.xz *. nx) +. (r.yz *. ny) +. (r.zz *. nz) in
  Solid.uphill f.solid dx dy dz ~from:start

let copy s k l =
  if k <> l then begin
    s.va.(l) <- s.va.(k);
    s.vb.(l) <- s.vb.(k);
    s.weight.(l) <- s.weight.(k);
    for c = 0 to 2 do
      set s.p ((3 * l) + c) (get s.p ((3 * k) + c))
    done
  end

(* Leaves the corners of a weight. *)
let compact s =
  let left = ref 0 in
  for k = 0 to s.count - 1 do
    if s.weight.(k) > 0. then begin
      copy s k !left;
      incr left
    end
  done;
  s.count <- !left

(* {1 The nearest point of a triangle}

   By the regions of its vertices, edges and face that the origin projects to. *)

let weigh s i wi j wj k wk =
  s.weight.(i) <- wi;
  s.weight.(j) <- wj;
  s.weight.(k) <- wk

let triangle s i j k =
  let p = s.p and a = 3 * i and b = 3 * j and c = 3 * k in
  let ax = get p a and ay = get p (a + 1) and az = get p (a + 2) in
  let bx = get p b and by = get p (b + 1) and bz = get p (b + 2) in
  let cx = get p c and cy = get p (c + 1) and cz = get p (c + 2) in
  let ex = bx -. ax and ey = by -. ay and ez = bz -. az in
  let fx = cx -. ax and fy = cy -. ay and fz = cz -. az in
  (* products of b - a and c - a with the vectors from a, b and c to the origin *)
  let d1 = -.((ex *. ax) +. (ey *. ay) +. (ez *. az)) and d2 = -.((fx *. ax) +. (fy *. ay) +. (fz *. az)) in
  let d3 = -.((ex *. bx) +. (ey *. by) +. (ez *. bz)) and d4 = -.((fx *. bx) +. (fy *. by) +. (fz *. bz)) in
  let d5 = -.((ex *. cx) +. (ey *. cy) +. (ez *. cz)) and d6 = -.((fx *. cx) +. (fy *. cy) +. (fz *. cz)) in
  if d1 <= 0. && d2 <= 0. then weigh s i 1. j 0. k 0.
  else if d3 >= 0. && d4 <= d3 then weigh s i 0. j 1. k 0.
  else if d6 >= 0. && d5 <= d6 then weigh s i 0. j 0. k 1.
  else begin
    let vc = (d1 *. d4) -. (d3 *. d2) in
    let vb = (d5 *. d2) -. (d1 *. d6) in
    let va = (d3 *. d6) -. (d5 *. d4) in
    if vc <= 0. && d1 >= 0. && d3 <= 0. then
      let w = d1 /. (d1 -. d3) in
      weigh s i (1. -. w) j w k 0.
    else if vb <= 0. && d2 >= 0. && d6 <= 0. then
      let w = d2 /. (d2 -. d6) in
      weigh s i (1. -. w) j 0. k w
    else if va <= 0. && d4 >= d3 && d5 >= d6 then
      let w = (d4 -. d3) /. (d4 -. d3 +. (d5 -. d6)) in
      weigh s i 0. j (1. -. w) k w
    else
      let all = va +. vb +. vc in
      weigh s i (va /. all) j (vb /. all) k (vc /. all)
  end

let segment s =
  let p = s.p in
  let ex = get p 3 -. get p 0 and ey = get p 4 -. get p 1 and ez = get p 5 -. get p 2 in
  let w =
    -.((ex *. get p 0) +. (ey *. get p 1) +. (ez *. get p 2)) /. ((ex *. ex) +. (ey *. ey) +. (ez *. ez))
  in
  let w = if w > 0. then Float.min w 1. else 0. in
  s.weight.(0) <- 1. -. w;
  s.weight.(1) <- w

(* {1 The nearest point of a tetrahedron} *)

(* For the plane of corners i, j and k: the height of the origin over that of corner l, the plane being at
   height 0. Positive when both are on one side of it. *)
let height s i j k l =
  let p = s.p and a = 3 * i and b = 3 * j and c = 3 * k and d = 3 * l in
  let ax = get p a and ay = get p (a + 1) and az = get p (a + 2) in
  let ex = get p b -. ax and ey = get p (b + 1) -. ay and ez = get p (b + 2) -. az in
  let fx = get p c -. ax and fy = get p (c + 1) -. ay and fz = get p (c + 2) -. az in
  let nx = (ey *. fz) -. (ez *. fy) and ny = (ez *. fx) -. (ex *. fz) and nz = (ex *. fy) -. (ey *. fx) in
  -.((nx *. ax) +. (ny *. ay) +. (nz *. az))
    /. ((nx *. (get p d -. ax)) +. (ny *. (get p (d + 1) -. ay)) +. (nz *. (get p (d + 2) -. az)))

(* The point of the weights, in [n]. *)
let combine s =
  let p = s.p in
  let x = ref 0. and y = ref 0. and z = ref 0. and all = ref 0. in
  for k = 0 to s.count - 1 do
    let w = get s.weight k in
    x := !x +. (w *. get p (3 * k));
    y := !y +. (w *. get p ((3 * k) + 1));
    z := !z +. (w *. get p ((3 * k) + 2));
    all := !all +. w
  done;
  s.n.(0) <- !x /. !all;
  s.n.(1) <- !y /. !all;
  s.n.(2) <- !z /. !all

let size s = sqrt ((get s.n 0 *. get s.n 0) +. (get s.n 1 *. get s.n 1) +. (get s.n 2 *. get s.n 2))

(* Whether the origin lies inside; else the weights are those of the nearest point on the faces that it is outside
   of. A face that is seen edge-on counts as one of these. *)
let tetrahedron s =
  let h0 = height s 1 2 3 0 and h1 = height s 0 2 3 1 and h2 = height s 0 1 3 2 and h3 = height s 0 1 2 3 in
  if h0 > 0. && h1 > 0. && h2 > 0. && h3 > 0. then begin
    weigh s 0 h0 1 h1 2 h2;
    s.weight.(3) <- h3;
    true
  end
  else begin
    let best = ref infinity in
    let w0 = ref 1. and w1 = ref 0. and w2 = ref 0. and w3 = ref 0. in
    let look i j k l =
      triangle s i j k;
      s.weight.(l) <- 0.;
      combine s;
      let size = size s in
      if size < !best then begin
        best := size;
        w0 := s.weight.(0);
        w1 := s.weight.(1);
        w2 := s.weight.(2);
        w3 := s.weight.(3)
      end
    in
    if not (h0 > 0.) then look 1 2 3 0;
    if not (h1 > 0.) then look 0 2 3 1;
    if not (h2 > 0.) then look 0 1 3 2;
    if not (h3 > 0.) then look 0 1 2 3;
    weigh s 0 !w0 1 !w1 2 !w2;
    s.weight.(3) <- !w3;
    false
  end

(* {1 The search} *)

(* [n] := the unit vector towards the nearest point; its distance. Of a triangle, the normal of its plane is more
   precise than the vector to the nearest point. *)
let aim s =
  let p = s.p and n = s.n in
  if s.count = 3 then begin
    let ex = get p 3 -. get p 0 and ey = get p 4 -. get p 1 and ez = get p 5 -. get p 2 in
    let fx = get p 6 -. get p 0 and fy = get p 7 -. get p 1 and fz = get p 8 -. get p 2 in
    n.(0) <- (ey *. fz) -. (ez *. fy);
    n.(1) <- (ez *. fx) -. (ex *. fz);
    n.(2) <- (ex *. fy) -. (ey *. fx)
  end
  else combine s;
  let h = (get n 0 *. get p 0) +. (get n 1 *. get p 1) +. (get n 2 *. get p 2) in
  let scale = (if h < 0. then -1. else 1.) /. size s in
  n.(0) <- scale *. get n 0;
  n.(1) <- scale *. get n 1;
  n.(2) <- scale *. get n 2;
  scale *. h

let known s i j =
  let rec search k = k < s.count && ((s.va.(k) = i && s.vb.(k) = j) || search (k + 1)) in
  search 0

let most_corners = 48

(* Whether the origin lies in the tetrahedron; else the corners are those of the nearest point. *)
let reduce s =
  match s.count with
  | 4 when tetrahedron s -> true
  | count ->
    if count = 3 then triangle s 0 1 2 else if count = 2 then segment s else if count = 1 then s.weight.(0) <- 1.;
    compact s;
    false

let rec descend s left =
  if reduce s then Near
  else
    let distance = aim s in
    let noise = Flight.epsilon *. s.flight.scales.length in
    if not (distance > noise) then Near
    else if left = 0 then Apart distance
    else
      let i = highest s.flight.a s.n 1. s.va.(0) and j = highest s.flight.b s.n (-1.) s.vb.(0) in
      let k = s.count in
      if known s i j then Apart distance
      else begin
        place s k i j;
        let p = s.p and n = s.n in
        let h =
          (get n 0 *. get p (3 * k)) +. (get n 1 *. get p ((3 * k) + 1)) +. (get n 2 *. get p ((3 * k) + 2))
        in
        if h >= distance -. (0x1p-3 *. noise) -. (0x1p-30 *. distance) then Apart distance
        else begin
          s.count <- k + 1;
          descend s (left - 1)
        end
      end

(* The vector between the inner points is the first direction. *)
let between (f : Flight.t) (n : float array) =
  let a = f.a.now and b = f.b.now and sa = f.a.solid.shadow and sb = f.b.solid.shadow in
  let across ax ay az ae bx by bz be =
    be +. ((bx *. sb.cx) +. (by *. sb.cy) +. (bz *. sb.cz))
    -. (ae +. ((ax *. sa.cx) +. (ay *. sa.cy) +. (az *. sa.cz)))
  in
  n.(0) <- f.here.(0) +. across a.xx a.xy a.xz a.ex b.xx b.xy b.xz b.ex;
  n.(1) <- f.here.(1) +. across a.yx a.yy a.yz a.ey b.yx b.yy b.yz b.ey;
  n.(2) <- f.here.(2) +. across a.zx a.zy a.zz a.ez b.zx b.zy b.zz b.ez

let search s =
  if s.count = 0 then begin
    between s.flight s.n;
    place s 0 (highest s.flight.a s.n 1. (-1)) (highest s.flight.b s.n (-1.) (-1));
    s.count <- 1
  end
  else
    for k = 0 to s.count - 1 do
      place s k s.va.(k) s.vb.(k)
    done;
  descend s most_corners

let miss s k =
  between s.flight s.shift;
  for c = 0 to 2 do
    set s.shift c (k *. get s.shift c)
  done;
  let _ : found = search s in
  combine s;
  let miss = size s in
  Array.fill s.shift 0 3 0.;
  miss

let depth s = s.flight.a.solid.shadow.inner +. s.flight.b.solid.shadow.inner
