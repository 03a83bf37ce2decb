(* The server of scc lsp, piece by piece: places in three encodings, and framing. *)

open Scc_lsp

let case name f = Alcotest.test_case name `Quick f

(* {1 Places} *)

let text = "a\nbé𝄞c\r\n\rd𝄞"

let encodings = [ (Positions.Utf8, 1); (Utf16, 1); (Utf32, 1) ]

(* By hand: line 1 is b, é (2 bytes, 1 unit), 𝄞 (4 bytes, 2 units), c. *)
let by_hand () =
  let at encoding = Positions.of_offset (Positions.make encoding text) in
  let pair = Alcotest.(check (pair int int)) in
  pair "bytes" (1, 7) (at Utf8 9);
  pair "units" (1, 4) (at Utf16 9);
  pair "code points" (1, 3) (at Utf32 9);
  pair "after both marks" (2, 0) (at Utf16 12);
  pair "after a carriage return" (3, 0) (at Utf16 13);
  pair "the end" (3, 3) (at Utf16 (String.length text));
  let offset encoding = Positions.offset (Positions.make encoding text) in
  Alcotest.(check int) "within a pair" 5 (offset Utf16 (1, 3));
  Alcotest.(check int) "within a code point" 3 (offset Utf8 (1, 2));
  Alcotest.(check int) "past the end of a line" 10 (offset Utf16 (1, 99));
  Alcotest.(check int) "past the end" (String.length text) (offset Utf16 (99, 0));
  Alcotest.(check int) "before the beginning" 0 (offset Utf16 (-1, 5))

(* Long lines of all kinds of characters: each place of a code point comes back. *)
let round () =
  let pieces = [| "x"; "é"; "…"; "𝄞"; "\n"; "yz"; "\r\n" |] in
  let state = ref 7 in
  let next n = state := (!state * 1103515245 + 12345) land 0x3fffffff; !state / 65536 mod n in
  for _ = 1 to 50 do
    let text = String.concat "" (List.init (next 400) (fun _ -> pieces.(next 7))) in
    let check (encoding, _) =
      let places = Positions.make encoding text in
      let within i = i > 0 && i < String.length text && text.[i] = '\n' && text.[i - 1] = '\r' in
      for i = 0 to String.length text do
        let continues = i < String.length text && Char.code text.[i] land 0xC0 = 0x80 in
        if (not continues) && not (within i) then
          Alcotest.(check int) "there and back" i (Positions.offset places (Positions.of_offset places i))
      done
    in
    List.iter check encodings
  done

(* {1 Addresses} *)

let addresses () =
  let path = Alcotest.(check (option string)) in
  path "plain" (Some "/a/b.sc") (Uri.path "file:///a/b.sc");
  path "encoded" (Some "/a b/é%.sc") (Uri.path "file:///a%20b/%C3%A9%25.sc");
  path "of no escape" (Some "/a%zz%4") (Uri.path "file:///a%zz%4");
  path "with dots" (Some "/b.sc") (Uri.path "file:///a/./../b.sc");
  path "of this machine" (Some "/a") (Uri.path "file://localhost/a");
  path "of another one" None (Uri.path "file://other/a");
  path "of no file" None (Uri.path "untitled:a");
  List.iter (fun p -> path p (Some p) (Uri.path (Uri.of_path p))) [ "/a b"; "/é/𝄞#?"; "/%41" ]

(* {1 Framing} *)

(* What is fed in pieces of some bytes. *)
let pieces size input =
  let t = Frame.make ~most:1000 in
  let rec all found =
    match Frame.next t with
    | Message m -> all (("message " ^ m) :: found)
    | Fault _ -> all ("fault" :: found)
    | More -> found
  in
  let rec feed from found =
    if from >= String.length input then List.rev found
    else begin
      let n = Int.min size (String.length input - from) in
      Frame.feed t (Bytes.of_string (String.sub input from n)) n;
      feed (from + n) (all found)
    end
  in
  feed 0 []

let framing () =
  let is what input wanted =
    let by size =
      Alcotest.(check (list string)) (Printf.sprintf "%s, by %d" what size) wanted (pieces size input)
    in
    List.iter by [ 1; 2; 7; 100000 ]
  in
  is "two messages" (Frame.framed "ab" ^ Frame.framed "c") [ "message ab"; "message c" ];
  is "an empty message" (Frame.framed "") [ "message " ];
  is "line feeds alone" "content-LENGTH:2\n\nab" [ "message ab" ];
  is "more fields" ("Content-Type: x; charset=utf-8\r\n" ^ Frame.framed "ab") [ "message ab" ];
  is "no length" ("X: 1\r\n\r\n" ^ Frame.framed "ab") [ "fault"; "message ab" ];
  is "content without a header" ("{}\r\n\r\n{}" ^ Frame.framed "ab") [ "fault"; "message ab" ];
  let large = "Content-Length: 1001\r\n\r\n" ^ String.make 1001 'x' in
  is "too large" (large ^ Frame.framed "ab") [ "fault"; "message ab" ];
  let larger = "Content-Length: 99999999999999999999\r\n\r\n" in
  is "a length beyond all" (larger ^ Frame.framed "ab") [ "fault"; "message ab" ]

let () =
  Alcotest.run "lsp"
    [
      ("places", [ case "by hand" by_hand; case "there and back" round ]);
      ("addresses", [ case "paths" addresses ]);
      ("framing", [ case "whole, and in pieces" framing ]);
    ]
