(* Pictures: every type of PNG, made here; Netpbm; SVG against formulas; and files that are broken. *)
open Scc_base
open Scc_pixels
module G = QCheck2.Gen

let read ?resolution text = Icon.read ?resolution ~path:"icon" text

let ok ?resolution name text =
  match read ?resolution text with
  | Ok r -> r
  | Error d -> Alcotest.failf "%s: %s" name d.Diag.message

(* {1 PNG} *)

let be n width = String.init width (fun k -> Char.chr ((n lsr (8 * (width - 1 - k))) land 255))

let chunk kind data =
  let crc = Int32.to_int (Zlib.update_crc_string 0l (kind ^ data) 0 (4 + String.length data)) land 0xffffffff in
  be (String.length data) 4 ^ kind ^ data ^ be crc 4

let deflate text =
  let b = Buffer.create 64 and at = ref 0 in
  Zlib.compress
    (fun bytes ->
       let n = min (Bytes.length bytes) (String.length text - !at) in
       Bytes.blit_string text !at bytes 0 n;
       at := !at + n;
       n)
    (fun bytes n -> Buffer.add_subbytes b bytes 0 n);
  Buffer.contents b

let channels = function 0 | 3 -> 1 | 2 -> 3 | 4 -> 2 | _ -> 4

(* A row of samples as bytes, most significant bit first. *)
let pack depth samples =
  let b = Buffer.create 16 in
  if depth >= 8 then List.iter (fun s -> Buffer.add_string b (be s (depth / 8))) samples
  else begin
    let bits = ref 0 and count = ref 0 in
    let flush () =
      if !count > 0 then Buffer.add_char b (Char.chr (!bits lsl (8 - !count)));
      bits := 0;
      count := 0
    in
    List.iter
      (fun s ->
         bits := (!bits lsl depth) lor s;
         count := !count + depth;
         if !count = 8 then flush ())
      samples;
    flush ()
  end;
  Buffer.contents b

let paeth a b c =
  let p = a + b - c in
  let da = abs (p - a) and db = abs (p - b) and dc = abs (p - c) in
  if da <= db && da <= dc then a else if db <= dc then b else c

(* Each row by another filter. *)
let filtered ~step rows =
  let byte row k = if k < 0 then 0 else Char.code row.[k] in
  let _, text =
    List.fold_left
      (fun ((above, n), text) row ->
         let filter = n mod 5 in
         let up k = if above = "" || k < 0 then 0 else Char.code above.[k] in
         let one k c =
           let left = byte row (k - step) in
           let predicted =
             match filter with
             | 0 -> 0
             | 1 -> left
             | 2 -> up k
             | 3 -> (left + up k) / 2
             | _ -> paeth left (up k) (if k >= step then up (k - step) else 0)
           in
           Char.chr ((Char.code c - predicted) land 255)
         in
         ((row, n + 1), text ^ String.make 1 (Char.chr filter) ^ String.mapi one row))
      (("", 0), "") rows
  in
  text

let passes interlaced =
  if interlaced then
    [ (0, 0, 8, 8); (4, 0, 8, 8); (0, 4, 4, 8); (2, 0, 4, 4); (0, 2, 2, 4); (1, 0, 2, 2); (0, 1, 1, 2) ]
  else [ (0, 0, 1, 1) ]

let rec from a step stop = if a >= stop then [] else a :: from (a + step) step stop

(* [sample x y k] of a picture. *)
let png ?(extra = "") ~width ~height ~kind ~depth ~interlaced sample =
  let n = channels kind in
  let pass (x0, y0, dx, dy) =
    let columns = from x0 dx width in
    if columns = [] then ""
    else
      from y0 dy height
      |> List.map (fun y -> pack depth (List.concat_map (fun x -> List.init n (sample x y)) columns))
      |> filtered ~step:(max 1 (n * depth / 8))
  in
  let data = deflate (String.concat "" (List.map pass (passes interlaced))) in
  let half = String.length data / 2 in
  let header = be width 4 ^ be height 4 ^ be depth 1 ^ be kind 1 ^ "\000\000" ^ be (Bool.to_int interlaced) 1 in
  "\137PNG\r\n\026\n" ^ chunk "IHDR" header ^ extra
  ^ chunk "IDAT" (String.sub data 0 half)
  ^ chunk "tEXt" "between"
  ^ chunk "IDAT" (String.sub data half (String.length data - half))
  ^ chunk "IEND" ""

let types = [ (0, [ 1; 2; 4; 8; 16 ]); (2, [ 8; 16 ]); (3, [ 1; 2; 4; 8 ]); (4, [ 8; 16 ]); (6, [ 8; 16 ]) ]

let all_types () =
  List.iter
    (fun (kind, depths) ->
       List.iter
         (fun depth ->
            List.iter
              (fun (width, height) ->
                 let name = Printf.sprintf "type %d, %d bits, %d x %d" kind depth width height in
                 let most = (1 lsl depth) - 1 in
                 let sample x y k = ((x * 7919) + (y * 104729) + (k * 31) + 5) * 2654435761 land most in
                 let palette = String.init (3 * 256) (fun k -> Char.chr (k * 37 land 255)) in
                 let extra = if kind = 3 then chunk "PLTE" palette ^ chunk "tRNS" "\003\200" else "" in
                 let picture interlaced = ok name (png ~extra ~width ~height ~kind ~depth ~interlaced sample) in
                 let plain = picture false and interlaced = picture true in
                 Alcotest.(check bool) (name ^ ": interlaced") true (plain = interlaced);
                 for y = 0 to height - 1 do
                   for x = 0 to width - 1 do
                     let level k = let s = sample x y k in if depth = 16 then s / 256 else s * 255 / most in
                     let rgb r g b = (r lsl 16) lor (g lsl 8) lor b in
                     let colour, alpha =
                       match kind with
                       | 0 -> (rgb (level 0) (level 0) (level 0), 255)
                       | 2 -> (rgb (level 0) (level 1) (level 2), 255)
                       | 4 -> (rgb (level 0) (level 0) (level 0), level 1)
                       | 6 -> (rgb (level 0) (level 1) (level 2), level 3)
                       | _ ->
                         let n = sample x y 0 in
                         let byte k = Char.code palette.[(3 * n) + k] in
                         (rgb (byte 0) (byte 1) (byte 2), match n with 0 -> 3 | 1 -> 200 | _ -> 255)
                     in
                     Alcotest.(check (pair int int)) name (colour, alpha)
                       (plain.colours.((y * width) + x), Bytes.get_uint8 plain.alphas ((y * width) + x))
                   done
                 done)
              [ (1, 1); (3, 2); (9, 11); (16, 8) ])
         depths)
    types;
  (* One colour alone is transparent. *)
  let extra = chunk "tRNS" "\000\007" in
  let grey = png ~extra ~width:2 ~height:1 ~kind:0 ~depth:8 ~interlaced:false (fun x _ _ -> 7 + x) in
  Alcotest.(check string) "a transparent grey" "\000\255" (Bytes.to_string (ok "grey" grey).alphas)

(* {1 Netpbm} *)

let netpbm () =
  let same name expected text =
    Alcotest.(check (list int)) name expected (Array.to_list (ok name text).colours)
  in
  let black = 0 and white = 0xffffff in
  same "P1" [ black; white; white; black ] "P1 # a comment\n2 2\n10\n0 1\n";
  same "P2" [ black; white ] "P2\n2 1\n3\n0 3\n";
  same "P3" [ 0xff0000; 0x00ff80 ] "P3 2 1 255\n255 0 0 0 255 128";
  same "P4" [ black; white; black ] "P4\n3 1\n\xa0";
  same "P5" [ black; 0x808080 ] "P5 2 1 255\n\000\128";
  same "P5, two bytes" [ white ] "P5 1 1 1000\n\003\232";
  same "P6" [ 0x0a0b0c ] "P6\n1 1\n255\n\x0a\x0b\x0c"

(* {1 SVG} *)

let svg = Areas.svg
let area = Areas.area
let circle = Areas.circle
let box = Areas.box
let union = Areas.union
let both = Areas.both
let without = Areas.without

let shapes () =
  let disc = circle 20. 15. 10. in
  area "circle" "<circle cx='20' cy='15' r='10'/>" disc;
  area "arcs" "<path d='M10 15A10 10 0 0 1 30 15A10,10,0,0,1,10 15'/>" disc;
  area "large arc" "<path d='M20 5a10 10 0 1 0 10 10L20 15z'/>" (fun x y ->
      without disc (both (fun x _ -> 20. -. x) (fun _ y -> y -. 15.)) x y);
  area "arc flags without blanks" "<path d='M20 5a10 10 0 1010 10L20 15z'/>" (fun x y ->
      without disc (both (fun x _ -> 20. -. x) (fun _ y -> y -. 15.)) x y);
  area "large arc the other way" "<path d='M30 15A10 10 0 1 1 20 5L20 15z'/>" (fun x y ->
      without disc (both (fun x _ -> 20. -. x) (fun _ y -> y -. 15.)) x y);
  area "small arc" "<path d='M20 5A10 10 0 0 0 10 15L20 15z'/>"
    (both disc (both (fun x _ -> x -. 20.) (fun _ y -> y -. 15.)));
  area "too small radii grow" "<path d='M10 15A1 1 0 0 1 30 15A1 1 0 0 1 10 15'/>" disc;
  area "turned arcs"
    "<path d='M12.928932188 7.928932188A10 10 37 0 1 27.071067812 22.071067812\
     A10 10 -80 0 1 12.928932188 7.928932188'/>"
    disc;
  area "rect" "<rect x='5' y='6' width='20' height='10'/>" (box 5. 6. 25. 16.);
  area "round rect" "<rect x='5' y='6' width='20' height='10' rx='3'/>" (fun x y ->
      let dx = Float.max 0. (Float.abs (x -. 15.) -. 7.) and dy = Float.max 0. (Float.abs (y -. 11.) -. 2.) in
      Float.hypot dx dy -. 3.);
  area "hole by the even-odd rule"
    "<path fill-rule='evenodd' d='M0 0h30v20h-30zM5 5h10v10h-10z'/>"
    (without (box 0. 0. 30. 20.) (box 5. 5. 15. 15.));
  area "no hole by the other one" "<path d='M0 0h30v20h-30zM5 5h10v10h-10z'/>" (box 0. 0. 30. 20.);
  area "hole by winding" "<path d='M0 0H30V20H0zM5 5v10h10v-10z'/>"
    (without (box 0. 0. 30. 20.) (box 5. 5. 15. 15.));
  area "transforms"
    "<g transform='translate(20,15)'>\
     <rect transform='rotate(90) scale(2 1)' x='-5' y='-4' width='10' height='8'/></g>"
    (box 16. 5. 24. 25.);
  let turned x y = ((Float.abs (x -. 20.) +. Float.abs (y -. 15.)) /. sqrt 2.) -. 7. in
  area "rotation about a point" "<rect transform='rotate(45 20 15)' x='13' y='8' width='14' height='14'/>" turned;
  area "two shapes" "<circle cx='10' cy='15' r='5'/><polygon points='20,5 30,5 30,15 20,15'/>"
    (union (circle 10. 15. 5.) (box 20. 5. 30. 15.));
  (* y = x^2 / 20 as a quadratic curve and as the same cubic one. *)
  let parabola x y = ((x *. x /. 20.) -. y) /. Float.hypot 1. (x /. 10.) in
  let cap = both parabola (fun _ y -> y -. 20.) in
  area "quadratic" "<path d='M-20 20Q0 -20 20 20z'/>" cap;
  area "relative quadratic" "<path d='M-20 20q20,-40,40,0'/>" cap;
  area "cubic" "<path d='M-20 20C-6.6666666667 -6.6666666667 6.6666666667 -6.6666666667 20 20'/>" cap;
  area "smooth quadratics" "<path d='M-20 20Q-10 0 0 0T20 20'/>" cap;
  area "hidden things"
    "<g display='none'><rect width='9' height='9'/></g><rect style='fill:none' width='9' height='9'/>\
     <rect opacity='.4' width='9' height='9'/><rect x='1' y='1' width='5' height='5' style='opacity:60%'/>"
    (box 1. 1. 6. 6.);
  let squares =
    "<g fill='#f80'><rect width='1' height='1'/><rect x='1' width='1' height='1' fill='rgb(1,2,3)'/>\
     <rect x='2' width='1' height='1' style='fill: navy; stroke: none'/></g><rect x='3' width='1' height='1'/>"
  in
  let second = "<rect width='10' height='10'/><rect x='20' width='10' height='10' style='fill:none'/>" in
  let moved = union (box 0. 0. 10. 10.) (box 10. 0. 20. 10.) in
  let twice name by =
    area name ("<rect width='10' height='10'/><rect width='10' height='10' " ^ by ^ "/>") moved
  in
  area "another" second (box 0. 0. 10. 10.);
  twice "CSS: a translation" "style='transform:translate(10px,0)'";
  twice "CSS: in capitals, and over the attribute" "transform='scale(2)' style='TRANSFORM:TranslateX(10PX)'";
  twice "CSS: important" "style='transform:translateX(10px)!important;transform:none'";
  twice "CSS: a comment" "style='/* transform:none; */transform:/**/translate(10px)'";
  twice "CSS: half a turn about a point" "style='transform:rotate(.5turn);transform-origin:10px 5px'";
  twice "CSS: half a turn about a share" "style='transform:rotate(200grad);transform-origin:25% 5px'";
  twice "an origin as an attribute" "transform='rotate(180)' transform-origin='10 5'";
  twice "CSS: a mirror about words" "style='transform:translateX(-20px) scaleX(-1);transform-origin:top center'";
  area "CSS: names and words in capitals"
    "<rect width='40' height='30' style='FILL:NONE'/><rect width='9' height='9'/>"
    (box 0. 0. 9. 9.);
  area "the colour that is current" "<g color='transparent'><rect width='40' height='30' fill='currentColor'/></g>\
                                     <rect width='9' height='9'/>" (box 0. 0. 9. 9.);
  area "a stroke of no width" "<rect width='9' height='9' stroke='red' stroke-width='0'/>" (box 0. 0. 9. 9.);
  area "opacities within each other" "<g fill-opacity='.4'><rect width='9' height='9' fill-opacity='.6'/></g>"
    (box 0. 0. 9. 9.);
  let colours = ok ~resolution:4 "colours" (svg ~box:"0 0 4 1" squares) in
  Alcotest.(check (list int)) "colours" [ 0xff8800; 0x010203; 0x000080; 0 ] (Array.to_list colours.colours)

(* {1 What is refused} *)

let code text = match read text with Ok _ -> "read" | Error d -> (d.code :> string)

let refused () =
  let is expected name text = Alcotest.(check string) name expected (code text) in
  let header w h = "\137PNG\r\n\026\n" ^ chunk "IHDR" (be w 4 ^ be h 4 ^ "\008\002\000\000\000") in
  is "SC0341" "nothing" "";
  is "SC0341" "another format" "GIF89a";
  is "SC0340" "no more than a header" (header 3 3);
  is "SC0342" "a hundred megapixels" (header 10_000 10_000);
  is "SC0342" "as many as fit a header" (header 0xffffffff 0xffffffff);
  is "SC0342" "Netpbm, large" "P5 99999999 99999999 255\n";
  is "SC0340" "Netpbm, no pixels" "P5 0 3 255\n";
  is "SC0340" "Netpbm, short" "P5 3 3 255\nabc";
  is "SC0340" "Netpbm, a large sample" "P2 1 1 3 4";
  let one = png ~width:1 ~height:1 ~kind:0 ~depth:8 ~interlaced:false (fun _ _ _ -> 0) in
  is "read" "a whole one" one;
  is "SC0340" "a wrong checksum" (String.mapi (fun i c -> if i = String.length one - 1 then 'x' else c) one);
  is "SC0340" "fewer rows" (header 9 9 ^ chunk "IDAT" (deflate "\000abc") ^ chunk "IEND" "");
  is "SC0340" "more rows" (header 1 1 ^ chunk "IDAT" (deflate "\000abc\000abc") ^ chunk "IEND" "");
  is "read" "one row" (header 1 1 ^ chunk "IDAT" (deflate "\000abc") ^ chunk "IEND" "");
  is "SC0340" "an unknown critical chunk"
    (header 1 1 ^ chunk "ABCD" "" ^ chunk "IDAT" (deflate "\000abc") ^ chunk "IEND" "");
  is "read" "an unknown chunk" (header 1 1 ^ chunk "abCD" "" ^ chunk "IDAT" (deflate "\000abc") ^ chunk "IEND" "");
  is "SC0340" "bytes after the end" (one ^ "x");
  List.iter
    (fun (name, text, more) ->
       is "read" name text;
       is "read" (name ^ ", and blanks") (text ^ "\n \n");
       is "SC0340" (name ^ ", and more") (text ^ more))
    [ ("P1", "P1 2 1 0 1", "1"); ("P2", "P2 1 1 9 4", " 5"); ("P3", "P3 1 1 9 1 2 3", " 1 2 3");
      ("P4", "P4 1 1 a", "a"); ("P5", "P5 1 1 255 a", "a"); ("P6", "P6 1 1 255 abc", "P6 1 1 255 abc") ];
  is "SC0341" "a condition" (svg "<rect requiredFeatures='a' width='9' height='9'/>");
  is "SC0340" "no compressed data" (header 9 9 ^ chunk "IDAT" "rubbish" ^ chunk "IEND" "");
  is "SC0340" "a colour that the palette has not"
    (png ~extra:(chunk "PLTE" "abc") ~width:1 ~height:1 ~kind:3 ~depth:8 ~interlaced:false (fun _ _ _ -> 1));
  is "SC0340" "no SVG" "<svg xmlns='http://www.w3.org/2000/svg'";
  is "SC0341" "another root" "<html/>";
  is "SC0340" "a path that begins with a line" (svg "<path d='L6 0V6H0z'/>");
  is "SC0340" "a path that begins with a number" (svg "<path d='6 0V6H0z'/>");
  is "SC0340" "a length without a unit in CSS" (svg "<rect style='transform:translate(2,0)' width='9'/>");
  is "SC0341" "a turn in space" (svg "<rect style='transform:rotateX(9deg)' width='9' height='9'/>");
  is "SC0341" "a transform of a box"
    (svg "<rect style='transform:rotate(9deg);transform-box:fill-box' width='9'/>");
  is "SC0341" "a width as a property" (svg "<rect style='width:9px' height='9'/>");
  is "SC0341" "an arrow head" (svg "<path marker-end='url(#a)' d='M0 0H9V9z'/>");
  is "SC0341" "something that moves" (svg "<rect width='9' height='9'><animate attributeName='x' to='9'/></rect>");
  is "SC0341" "an attribute that is not known" (svg "<rect width='9' heigth='9'/>");
  is "SC0341" "a drawing that is stretched"
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 4 4' preserveAspectRatio='none'/>";
  is "SC0341" "text" (svg "<text>x</text>");
  let declared d = "<?xml version='1.0'?><!-- a --><!DOCTYPE svg PUBLIC '-//a' 'b' [" ^ d ^ "]>" in
  List.iter
    (fun d -> is "SC0341" ("a document type with " ^ d) (declared d ^ svg ""))
    [
      "<!ENTITY a '&b;'>"; "<!ENTITY a '<'>"; "<!ENTITY a SYSTEM 'b'>"; "<!ENTITY % a 'b'>";
      "<!ELEMENT svg ANY>";
    ];
  is "read" "entities, as programs write them"
    (declared "\n<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n<!-- x -->\n<!ENTITY w '9'>\n"
     ^ "<svg xmlns='&ns_svg;' viewBox='0 0 9 9'><rect width='&w;' height='&w;'/></svg>");
  is "SC0340" "an entity again and again"
    (declared ("<!ENTITY a '" ^ String.make 100_000 'a' ^ "'>")
     ^ svg (String.concat "" (List.init 200 (fun _ -> "<title>&a;</title>"))));
  is "SC0341" "UTF-16" "\xff\xfe<\000s\000"; is "SC0341" "compressed" "\x1f\x8b\008\000";
  is "read" "an empty path" (svg "<path d='none'/><rect width='9' height='9'/>");
  is "SC0340" "an entity" (svg "<title>&a;</title>");
  is "SC0340" "a path" (svg "<path d='M0 0 L1'/>");
  is "SC0340" "far away" (svg "<path d='M0 0 L1e9 1e9z'/>");
  is "SC0340" "deep" (svg (String.concat "" (List.init 1000 (fun _ -> "<g>"))));
  is "SC0340" "no size" (svg ~box:"0 0 0 4" "")

(* No exception, whatever the bytes. *)
let mutated seeds =
  let open G in
  let* text = oneofl seeds and* count = int_range 1 6 in
  let* changes = list_repeat count (pair (int_range 0 (String.length text - 1)) (int_range 0 255)) in
  let* cut = int_range 0 (4 * String.length text) in
  let b = Bytes.of_string text in
  List.iter (fun (i, c) -> Bytes.set b i (Char.chr c)) changes;
  let text = Bytes.to_string b in
  return (if cut < String.length text then String.sub text 0 cut else text)

(* With checksums made right again, so that faults come deeper. *)
let mended text =
  let b = Bytes.of_string text in
  let rec go i =
    if i + 12 <= String.length text then begin
      let n = Int32.to_int (String.get_int32_be text i) in
      if n >= 0 && n <= String.length text - i - 12 then begin
        Bytes.set_int32_be b (i + 8 + n) (Zlib.update_crc_string 0l text (i + 4) (n + 4));
        go (i + 12 + n)
      end
    end
  in
  go 8;
  Bytes.to_string b

let pngs =
  List.concat_map
    (fun (kind, depths) ->
       List.map
         (fun depth ->
            let extra = if kind = 3 then chunk "PLTE" (String.make 12 'p') else "" in
            let sample x y k = (x + y + k) land 3 land ((1 lsl depth) - 1) in
            png ~extra ~width:5 ~height:9 ~kind ~depth ~interlaced:(depth > 4) sample)
         depths)
    types

let texts =
  [
    "P2 # c\n2 2\n255\n0 1 2 3"; "P6\n2 1\n255\nabcdef"; "P1 2 2 1 0 0 1";
    svg "<rect style='Transform:rotate(.1turn) skew(3deg);transform-origin:5% top' width='9' height='9'/>";
    svg
      "<g transform='rotate(30 1 2) skewX(5)'>\
       <path style='fill:#123' d='M1 2l3,4-5.6.7e1zC1 2 3 4 5 6s7 8 9 9a1 2 30 1 0 4 4T3 3'/></g>";
    svg
      "<style>g > .a, #b{stroke:hsl(1 2% 3%);stroke-width:2;stroke-linejoin:round}</style>\
       <clipPath id='c'><rect width='9' height='9'/></clipPath>\
       <g clip-path='url(#c)'><path id='b' stroke-dasharray='3 1 2' d='M1 2l3,4-5.6Q3 4 5 6A9 3 4 0 1 2 2'/></g>\
       <use href='#b' x='2'/>\
       <svg viewBox='0 0 2 2' preserveAspectRatio='xMinYMax slice'><circle class='a' r='1'/></svg>";
    svg "<rect x='1' y='2mm' width='3' height='4' rx='1'/><ellipse cx='5' cy='5' rx='3' ry='2' opacity='50%'/>";
  ]

let survives text = match read ~resolution:16 text with Ok _ | Error _ -> true

let () =
  let property name count gen law =
    Scc_test_support.Property.case (QCheck2.Test.make ~name ~count ~print:String.escaped gen law) in
  Alcotest.run "icon"
    [
      ( "pictures",
        [
          Alcotest.test_case "PNG, every type" `Quick all_types; Alcotest.test_case "Netpbm" `Quick netpbm;
          Alcotest.test_case "SVG" `Quick shapes; Alcotest.test_case "refused" `Quick refused;
        ] );
      ( "mutated",
        [
          property "PNG" 2000 (mutated pngs) survives;
          property "PNG with right checksums" 4000 (G.map mended (mutated pngs)) survives;
          property "texts" 4000 (mutated texts) survives;
        ] );
    ]
