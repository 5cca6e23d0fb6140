import { chromium } from '@playwright/test';
const { findBrowser, findShell, CHROMIUM_FLAGS } = await import('/work/wt/models/scripts/setup/browser.mjs');
const b = await chromium.launch({ executablePath: findShell() || await findBrowser(), args: CHROMIUM_FLAGS });
for (const [w,h,m] of [[1440,900,false],[390,844,true]]) {
  const p = await b.newPage({ viewport: {width:w,height:h}, hasTouch: m, deviceScaleFactor: 1 });
  p.on('console', x => console.log(x.text())); p.on('pageerror', e => console.log('err', e.message));
  await p.goto('http://127.0.0.1:5199/puff.html'); await p.waitForSelector('#effects li:nth-child(9)');
  await p.screenshot({ path: `/tmp/puff-${w}.png`, fullPage: m });
  console.log(w, await p.evaluate(() => document.documentElement.scrollWidth));
  if (!m) {
    for (const n of ['boom','poof','dust']) { const t=Date.now(); await p.getByRole('button',{name:n,exact:true}).click(); await p.waitForTimeout(n==='boom'?6000:500);}
    await p.screenshot({ path: `/tmp/puff-${w}-smoke.png` });
  } else { await p.getByRole('button',{name:'poof',exact:true}).tap(); await p.waitForTimeout(2500); await p.screenshot({ path: `/tmp/puff-${w}-smoke.png` });}
  await p.close();
}
await b.close();
