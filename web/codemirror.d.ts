/* What the desk uses of CodeMirror 5. */

interface CmPosition {
  line: number;
  ch: number;
}

interface CmStream {
  sol(): boolean;
  eol(): boolean;
  peek(): string | undefined;
  next(): string | undefined;
  eatSpace(): boolean;
  skipToEnd(): void;
  match(pattern: string | RegExp, consume?: boolean): any;
}

interface CmMark {
  find(): { from: CmPosition; to: CmPosition } | undefined;
  clear(): void;
}

interface CmEditor {
  getValue(separator?: string): string;
  setValue(text: string): void;
  clearHistory(): void;
  changeGeneration(close?: boolean): number;
  isClean(generation: number): boolean;
  operation<T>(work: () => T): T;
  replaceRange(text: string, from: CmPosition, to?: CmPosition, origin?: string): void;
  replaceSelection(text: string): void;
  somethingSelected(): boolean;
  indentSelection(how: string): void;
  getCursor(): CmPosition;
  setCursor(at: CmPosition): void;
  setSelection(from: CmPosition, to: CmPosition): void;
  indexFromPos(at: CmPosition): number;
  posFromIndex(index: number): CmPosition;
  markText(from: CmPosition, to: CmPosition, options: { className: string }): CmMark;
  setGutterMarker(line: number, gutter: string, element: HTMLElement | null): void;
  clearGutter(gutter: string): void;
  scrollIntoView(at: { from: CmPosition; to: CmPosition }, margin: number): void;
  coordsChar(at: { left: number; top: number }, mode: "window"): CmPosition & { outside?: any };
  charCoords(at: CmPosition, mode: "window"): { left: number; right: number; top: number; bottom: number };
  focus(): void;
  hasFocus(): boolean;
  refresh(): void;
  getWrapperElement(): HTMLElement;
  getInputField(): HTMLElement;
  execCommand(name: string): void;
  on(event: string, heard: (editor: CmEditor, event: any) => void): void;
}

declare const CodeMirror: {
  (place: HTMLElement, options: { [name: string]: any }): CmEditor;
  defineMode(name: string, make: () => { [name: string]: any }): void;
  Pass: {};
};
