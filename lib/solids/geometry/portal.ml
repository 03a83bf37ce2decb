type triangle = { p : Point.t; q : Point.t; r : Point.t }
type edge = { right : Point.t; left : Point.t }

type line =
  | Apart of Shadow.floats
  | Beside of edge
  | Through of { portal : triangle; edge : edge }
  | Lost

type place = Apart of Shadow.floats | Inside of triangle | Facing of triangle | Lost

(* {1 The memory of a search}

   Vectors of three floats each, at places in [x]; and the points 0 to 5, whose vectors are among them: 0 to 2 are
   the portal, 3 the last support, 4 and 5 the edge, 5 on the left. *)
type t = {
  a : Solid.t;
  b : Solid.t;
  x : float array;
  points : Point.t array;
  bound : float;
  hasty : bool;  (** a plane that seems to separate ends the search *)
}

let direction = 0  (* the last in which a support was taken *)
let velocity = 3
let centre = 6
let point k = 9 + (3 * k)
let last = 3
let offset = 9 + (3 * 6)

(* What is not set yet is filled with anything: an array written out is made without a call. *)
let start { Question.a; b; offset = r; velocity = w; bound } ~hasty =
  let sa = a.shadow and sb = b.shadow and { Shadow.x = rx; y = ry; z = rz } = r in
  let cx = sa.cx -. sb.cx -. rx and cy = sa.cy -. sb.cy -. ry and cz = sa.cz -. sb.cz -. rz in
  let x =
    [|
      rx; rx; rx; w.x; w.y; w.z; cx; cy; cz;
      rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; rx; ry; rz;
    |]
  in
  let points = Point.[| none; none; none; none; none; none |] in
  { a; b; x; points; bound; hasty }

(* {1 Vectors by place}

   The array [x] has 30 places, and all that follows looks at places below. *)

let[@inline] get (a : float array) i = Array.unsafe_get a i

let[@inline] product (x : float array) i j =
  (get x i *. get x j) +. (get x (i + 1) *. get x (j + 1)) +. (get x (i + 2) *. get x (j + 2))

(* det (u, v, w) *)
let[@inline] det (x : float array) u v w =
  (get x u *. ((get x (v + 1) *. get x (w + 2)) -. (get x (v + 2) *. get x (w + 1))))
  +. (get x (u + 1) *. ((get x (v + 2) *. get x w) -. (get x v *. get x (w + 2))))
  +. (get x (u + 2) *. ((get x v *. get x (w + 1)) -. (get x (v + 1) *. get x w)))

(* direction := k (w x (v - u)) *)
let aim_across (x : float array) k u v =
  let wx = get x velocity and wy = get x (velocity + 1) and wz = get x (velocity + 2) in
  let ex = get x v -. get x u and ey = get x (v + 1) -. get x (u + 1) and ez = get x (v + 2) -. get x (u + 2) in
  x.(direction) <- k *. ((wy *. ez) -. (wz *. ey));
  x.(direction + 1) <- k *. ((wz *. ex) -. (wx *. ez));
  x.(direction + 2) <- k *. ((wx *. ey) -. (wy *. ex))

(* direction := (v - u) x (w - u) *)
let aim_normal (x : float array) u v w =
  let ex = get x v -. get x u and ey = get x (v + 1) -. get x (u + 1) and ez = get x (v + 2) -. get x (u + 2) in
  let fx = get x w -. get x u and fy = get x (w + 1) -. get x (u + 1) and fz = get x (w + 2) -. get x (u + 2) in
  x.(direction) <- (ey *. fz) -. (ez *. fy);
  x.(direction + 1) <- (ez *. fx) -. (ex *. fz);
  x.(direction + 2) <- (ex *. fy) -. (ey *. fx)

(* direction := -c *)
let aim_away s =
  let x = s.x in
  x.(direction) <- -.get x centre;
  x.(direction + 1) <- -.get x (centre + 1);
  x.(direction + 2) <- -.get x (centre + 2)

let[@inline] size (x : float array) u =
  Float.abs (get x u) +. Float.abs (get x (u + 1)) +. Float.abs (get x (u + 2))

(* The given direction, across w; but any direction across w when nothing but rounding is left of the given one,
   whose terms were as great as [scale]. *)
let aim_unless_noise s dx dy dz scale =
  let x = s.x in
  if Float.abs dx +. Float.abs dy +. Float.abs dz > 0x1p-40 *. scale then begin
    x.(direction) <- dx;
    x.(direction + 1) <- dy;
    x.(direction + 2) <- dz
  end
  else begin
    let wx = get x velocity and wy = get x (velocity + 1) and wz = get x (velocity + 2) in
    let ax = Float.abs wx and ay = Float.abs wy and az = Float.abs wz in
    if ax <= ay && ax <= az then begin
      x.(direction) <- 0.;
      x.(direction + 1) <- wz;
      x.(direction + 2) <- -.wy
    end
    else if ay <= az then begin
      x.(direction) <- -.wz;
      x.(direction + 1) <- 0.;
      x.(direction + 2) <- wx
    end
    else begin
      x.(direction) <- wy;
      x.(direction + 1) <- -.wx;
      x.(direction + 2) <- 0.
    end
  end

(* {1 Supports} *)

let place s k p =
  let x = s.x and i = Point.of_a p and j = Point.of_b p in
  let a = s.a.shadow and b = s.b.shadow in
  let at = point k in
  s.points.(k) <- p;
  x.(at) <- get a.xs i -. get b.xs j -. get x offset;
  x.(at + 1) <- get a.ys i -. get b.ys j -. get x (offset + 1);
  x.(at + 2) <- get a.zs i -. get b.zs j -. get x (offset + 2)
[@@inline]

let support s k =
  let x = s.x in
  place s k (Point.make ~of_a:(Solid.highest s.a x 1.) ~of_b:(Solid.highest s.b x (-1.)))

let copy s k l =
  let x = s.x in
  let p = point k and q = point l in
  x.(q) <- x.(p);
  x.(q + 1) <- x.(p + 1);
  x.(q + 2) <- x.(p + 2);
  s.points.(l) <- s.points.(k)

(* Points of the obstacle by their numbers, as places. *)
let p0 = point 0
let p1 = point 1
let p2 = point 2
let p3 = point 3
let p4 = point 4
let p5 = point 5

(* How a search ends; what was found is in its memory. *)
type ending = Separates | Past_edge | At_facet | Encloses | Nowhere

(* What a product of the direction with a point, or with a difference of points, may be off by, so that less
   is no progress. *)
let[@inline] noise s = 0x1p-49 *. s.bound *. size s.x direction

(* The last support was taken at p3. *)
let[@inline] same_as s k = Point.equal s.points.(last) s.points.(k)

(* No search that goes well takes so many rounds. *)
let rounds = 100

(* {1 Towards a facet}

   The portal p0, p1, p2 has the line pass through it, seen along w, with det(w, pi, pj) <= 0 for each side, so
   that its normal (p1 - p0) x (p2 - p0) runs against w. The support in that direction becomes the new corner,
   and of the three triangles that it makes with two of the old ones the one that the line passes through stays,
   until no point is beyond the portal. *)
let rec towards_facet s ~stop round =
  let x = s.x in
  if round = 0 then Nowhere
  else begin
    aim_normal x p0 p1 p2;
    let height = product x direction p0 in
    if stop && height > noise s then Encloses
    else begin
      support s last;
      let top = product x direction p3 in
      if stop && s.hasty && top < -.noise s then Separates
      else if same_as s 0 || same_as s 1 || same_as s 2 || top -. height <= noise s then At_facet
      else begin
        (* det (w, p3, pi) *)
        let wx = get x velocity and wy = get x (velocity + 1) and wz = get x (velocity + 2) in
        let vx = get x p3 and vy = get x (p3 + 1) and vz = get x (p3 + 2) in
        let mx = (wy *. vz) -. (wz *. vy) and my = (wz *. vx) -. (wx *. vz) and mz = (wx *. vy) -. (wy *. vx) in
        let q0 = (get x p0 *. mx) +. (get x (p0 + 1) *. my) +. (get x (p0 + 2) *. mz) in
        let q1 = (get x p1 *. mx) +. (get x (p1 + 1) *. my) +. (get x (p1 + 2) *. mz) in
        let q2 = (get x p2 *. mx) +. (get x (p2 + 1) *. my) +. (get x (p2 + 2) *. mz) in
        if q0 <= 0. && q1 >= 0. then replace s ~stop 2 round
        else if q1 <= 0. && q2 >= 0. then replace s ~stop 0 round
        else if q2 <= 0. && q0 >= 0. then replace s ~stop 1 round
        else begin
          (* the line passes by a corner, and rounding denies it all three: the least bad one *)
          let fit q r = Float.min (-.q) r in
          let f2 = fit q0 q1 and f0 = fit q1 q2 and f1 = fit q2 q0 in
          replace s ~stop (if f2 >= f0 && f2 >= f1 then 2 else if f0 >= f1 then 0 else 1) round
        end
      end
    end
  end

and replace s ~stop k round =
  copy s last k;
  towards_facet s ~stop (round - 1)

(* {1 A line}

   Seen along w, the obstacle is a convex polygon with the centre c inside, and the line a point, the origin.
   The points 4 and 5 have the ray from c through the origin pass between them, 5 on the left of 4. *)

let through_edge s =
  let x = s.x in
  let c = centre and p = p0 in
  x.(p) <- x.(c);
  x.(p + 1) <- x.(c + 1);
  x.(p + 2) <- x.(c + 2);
  s.points.(0) <- Point.none;
  copy s 5 1;
  copy s 4 2;
  towards_facet s ~stop:false rounds

(* The edge from 4 to 5 moves outwards until the origin is on this side of it, or nothing is on the other. *)
let rec across_edge s round =
  let x = s.x in
  if round = 0 then Nowhere
  else begin
    aim_across x (-1.) p4 p5;
    let height = product x direction p4 in
    if height > noise s then through_edge s
    else begin
      support s last;
      let top = product x direction p3 in
      if s.hasty && top < -.noise s then Separates
      else if same_as s 4 || same_as s 5 || top -. height <= noise s then Past_edge
      else begin
        copy s last (if det x velocity centre p3 >= 0. then 4 else 5);
        across_edge s (round - 1)
      end
    end
  end

(* From 4, with the origin on the side [k] of the line from c to it (1 for the left), to a point on the other
   side of the origin. *)
let rec other_side s k round =
  let x = s.x in
  if round = 0 then Nowhere
  else begin
    aim_across x k centre p4;
    support s 5;
    if s.hasty && product x direction p5 < -.noise s then Separates
    else if k *. det x velocity centre p5 > 0. then begin
      copy s 5 4;
      other_side s k (round - 1)
    end
    else begin
      if k < 0. then begin
        copy s 4 last;
        copy s 5 4;
        copy s last 5
      end;
      across_edge s rounds
    end
  end

(* From c towards the line. *)
let follow s ww cw =
  let x = s.x in
  let dx = (cw *. x.(velocity)) -. (ww *. x.(centre))
  and dy = (cw *. x.(velocity + 1)) -. (ww *. x.(centre + 1))
  and dz = (cw *. x.(velocity + 2)) -. (ww *. x.(centre + 2)) in
  aim_unless_noise s dx dy dz (ww *. size x centre);
  support s 4;
  if s.hasty && product x direction p4 < -.noise s then Separates
  else other_side s (if det x velocity centre p4 >= 0. then 1. else -1.) rounds

let search_line s =
  let x = s.x in
  let ww = product x velocity velocity and cw = product x centre velocity in
  if cw > 0. || not s.hasty then follow s ww cw
  else begin
    (* away from c: already apart, most of the time *)
    aim_away s;
    support s last;
    if product x direction p3 < -.noise s then Separates else follow s ww cw
  end

(* {1 A point}

   The line from c to the origin, so that w = c. First a portal: p0 towards the origin, p1 and p2 on either side,
   with the plane of c, p0 and p1 turned until the line passes between them. *)

let rec find_portal s round =
  let x = s.x in
  if round = 0 then Nowhere
  else begin
    aim_normal x centre p0 p1;
    support s 2;
    if s.hasty && product x direction p2 < -.noise s then Separates
    else if det x centre p0 p2 < 0. then begin
      copy s 2 1;
      find_portal s (round - 1)
    end
    else if det x centre p2 p1 < 0. then begin
      copy s 2 0;
      find_portal s (round - 1)
    end
    else begin
      (* in the order p0, p1, p2 all three products are to be negative *)
      towards_facet s ~stop:true rounds
    end
  end

let search_origin s =
  let x = s.x in
  let c = centre in
  x.(velocity) <- x.(c);
  x.(velocity + 1) <- x.(c + 1);
  x.(velocity + 2) <- x.(c + 2);
  aim_away s;
  support s 0;
  if s.hasty && product x direction p0 < -.noise s then Separates
  else begin
    let dx = (x.(c + 1) *. x.(p0 + 2)) -. (x.(c + 2) *. x.(p0 + 1))
    and dy = (x.(c + 2) *. x.(p0)) -. (x.(c) *. x.(p0 + 2))
    and dz = (x.(c) *. x.(p0 + 1)) -. (x.(c + 1) *. x.(p0)) in
    aim_unless_noise s dx dy dz (size x c *. size x p0);
    support s 1;
    if s.hasty && product x direction p1 < -.noise s then Separates
    else begin
      if det x centre p0 p1 > 0. then begin
        copy s 0 last;
        copy s 1 0;
        copy s last 1
      end;
      find_portal s rounds
    end
  end

(* {1 What was found} *)

let edge s = { right = s.points.(4); left = s.points.(5) }
let portal s = { p = s.points.(0); q = s.points.(1); r = s.points.(2) }
let aimed s : Shadow.floats = { x = s.x.(direction); y = s.x.(direction + 1); z = s.x.(direction + 2) }

let line s ending : line =
  match ending with
  | Separates -> Apart (aimed s)
  | Past_edge -> Beside (edge s)
  | At_facet ->
    (* a corner that is still the centre *)
    if Point.equal s.points.(0) Point.none then Lost else Through { portal = portal s; edge = edge s }
  | Encloses | Nowhere -> Lost

let cast question ~hasty =
  let s = start question ~hasty in
  line s (search_line s)

let through question { right; left } =
  let s = start question ~hasty:false in
  place s 4 right;
  place s 5 left;
  line s (through_edge s)

let locate question ~hasty : place =
  let s = start question ~hasty in
  match search_origin s with
  | Separates -> Apart (aimed s)
  | Past_edge | Nowhere -> Lost
  | At_facet -> Facing (portal s)
  | Encloses -> Inside (portal s)

type guess = {
  cast : Question.t -> hasty:bool -> line;
  through : Question.t -> edge -> line;
  locate : Question.t -> hasty:bool -> place;
}

let guess = { cast; through; locate }
